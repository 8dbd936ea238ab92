// Which picture of its scene a render job asks for.
#pragma once

#include "cli/render_job.h"

namespace lancer::cli {

/// Throws UsageError when the scene has no such camera or when the crop leaves the picture, and
/// UsageError or SceneError when it does not fit into memory.
View view_of(const RenderJob& job, const Scene& scene, const Session& session);

}  // namespace lancer::cli
