// What a scene is expected to achieve against POV-Ray: NAME.expect beside NAME.lancer.
//
// Only what differs from the defaults stands there, one `key value  # reason` to a line, and the
// reason is no decoration: a line without one is an error. `#` at the start of a line begins a
// comment.
//
//     unexplained      3      # coincident faces at the rim, where POV-Ray has no rule
//     docs/export.md displaced_share  0.002  # the lathe is tessellated, its outline is not
//     POV-Ray's to 1e-4 pixel refused          yes    # POV-Ray has no mesh with a texture on
//     single faces
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "judge/explain/explain.h"

namespace lancer::judge {

struct Expectations {
    Thresholds thresholds;
    /// The exporter may, and then must, refuse the scene.
    bool refused = false;
    std::string refusal_reason;
    /// "key value: reason" of every line, for the report.
    std::vector<std::string> reasons;
};

/// Reads the text of a sidecar. `name` is what messages call it. Throws FileError with the line's
/// number for an unknown key, one given twice, a value out of range and a missing reason.
Expectations parse_expectations(std::string_view text, const std::string& name);

/// The name of the sidecar of a scene file.
std::string expectations_beside(const std::string& scene_path);

/// The sidecar of a scene file; the defaults when there is none. Throws FileError.
Expectations read_expectations(const std::string& scene_path);

}  // namespace lancer::judge
