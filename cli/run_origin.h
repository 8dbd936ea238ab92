// The origin of a run's pictures, which their files record.
#pragma once

#include "cli/render_job.h"
#include "cli/scene_loader.h"
#include "model/io/origin.h"

namespace lancer::cli {

/// Every setting that decides pixels, as text.
std::string text_of(const Settings& settings);

/// The origin of one picture of a job: all that decides its pixels. The numbers of threads and of
/// rays side by side are not part of it.
///
/// \param settings  the settings in use, including those of the command line
io::Origin origin_of(const RenderJob& job, SceneLoader& loader, const Scene& scene,
                     const Settings& settings, const View& view, double frame, double time);

}  // namespace lancer::cli
