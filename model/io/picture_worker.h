// The process that works on one picture and then ends.
#pragma once

#include "model/io/image_module.h"
#include "model/io/picture_messages.h"

namespace lancer::io {

/// Drops the rights that this process does not need, then works on the request. `output` receives
/// the result, or the reason of a failure. Returns the exit code of the process.
int work_on(const PictureRequest& request, int input, int output, const ImageModule& module);

}  // namespace lancer::io
