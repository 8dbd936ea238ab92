// What the pictures of a run are made from, as their files tell it.
#pragma once

#include "cli/render_job.h"
#include "cli/scene_loader.h"
#include "model/io/origin.h"

namespace lancer::cli {

/// Every setting that decides pixels, in words.
std::string text_of(const Settings& settings);

/// One picture of a job: all that decides its pixels. Threads and rays side by side do not.
///
/// \param settings  those in use, the command line's word included
io::Origin origin_of(const RenderJob& job, SceneLoader& loader, const Scene& scene,
                     const Settings& settings, const View& view, double frame, double time);

}  // namespace lancer::cli
