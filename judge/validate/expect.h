// What a scene must achieve against POV-Ray: NAME.expect beside NAME.lancer.
//
// The file lists only values that differ from the defaults, one `key value  # reason` per line. The
// reason is required: a line without one is an error. `#` at the start of a line begins a comment.
//
//     unexplained      3      # coincident faces at the rim: POV-Ray has no rule (docs/export.md)
//     displaced_share  0.002  # our lathe is tessellated: its outline is off by over 1e-4 pixel
//     refused          yes    # POV-Ray has no mesh with a texture on single faces
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "judge/explain/explain.h"

namespace lancer::judge {

struct Expectations {
    Thresholds thresholds;
    /// The exporter may refuse the scene, and then it must.
    bool refused = false;
    std::string refusal_reason;
    /// "key value: reason" of every line, for the report.
    std::vector<std::string> reasons;
};

/// Parses the text of a sidecar file, which messages call `name`. Throws FileError with the line's
/// number for an unknown key, a repeated key, a value out of range or a missing reason.
Expectations parse_expectations(std::string_view text, const std::string& name);

/// The name of the sidecar file of a scene file.
std::string expectations_beside(const std::string& scene_path);

/// Reads the sidecar file of a scene file; the defaults when there is none. Throws FileError.
Expectations read_expectations(const std::string& scene_path);

}  // namespace lancer::judge
