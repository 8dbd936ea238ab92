// The view of its scene that a render job asks for.
#pragma once

#include "cli/render_job.h"

namespace lancer::cli {

/// Throws UsageError when the scene has no such camera or the crop leaves the picture; UsageError
/// or SceneError when the picture does not fit into memory.
View view_of(const RenderJob& job, const Scene& scene, const Session& session);

}  // namespace lancer::cli
