// The process that works on one picture, and ends with it.
#pragma once

#include "model/io/image_module.h"
#include "model/io/picture_messages.h"

namespace lancer::io {

/// Gives up what this process does not need, then does what is asked. `output` holds what came of
/// it, a reason for its failure too. Returns the exit code of the process.
int work_on(const PictureRequest& request, int input, int output, const ImageModule& module);

}  // namespace lancer::io
