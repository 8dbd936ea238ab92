// Our side of a validation: the tracer's picture, its probes, and the judge's own recursion.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "judge/explain/probe_function.h"
#include "model/scene.h"
#include "reference/pov/export.h"
#include "tracer/render.h"

namespace lancer::judge {

struct OurPicture {
    Image image;          ///< linear light, 3 channels, not clamped
    ProbeFunction probe;  ///< the same picture between the pixels' centres, in the same units
    /// The same by the judge's own recursion, with POV-Ray's rules or, when `rules` are not
    /// followed, with ours; may be empty. Compiles the scene at the first call.
    std::function<ProbeFunction(const PovRayRules& rules)> by_rules;
    std::uint64_t rays = 0;  ///< of all kinds, for the picture
    double seconds = 0;
};

/// Renders what `view` shows of the scene, one ray through the centre of each pixel. Called from
/// several threads. Throws SceneError.
using OurRenderer = std::function<OurPicture(const std::shared_ptr<const Scene>& scene,
                                             const reference::ExportView& view)>;

/// Lancer's renderer. It uses one thread, because whole scenes run in parallel; the other settings
/// are the scene's.
OurPicture render_ours(const std::shared_ptr<const Scene>& scene,
                       const reference::ExportView& view);

/// Probes of a scene by the judge's own recursion. Compiles the scene at the first call.
ProbeFunction probe_by_rules(const std::shared_ptr<const Scene>& scene, const View& view,
                             const PovRayRules& rules);

/// The tracer's view for the view of the export.
View tracer_view(const reference::ExportView& view);

/// The rules by which our tracer imitates POV-Ray on an exported file.
PovRayRules rules_of(const reference::ExportResult& exported);

}  // namespace lancer::judge
