// Checks a render job as far as possible before its scene is read.
#pragma once

#include <string>

#include "cli/render_job.h"

namespace lancer::cli {

/// Throws UsageError for options that contradict each other, and UsageError or FileError for a name
/// that the picture cannot have.
void check(const RenderJob& job, const std::string& output);

}  // namespace lancer::cli
