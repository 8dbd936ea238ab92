// What our renderer must know to trace a ray by POV-Ray's rules instead of its own.
#pragma once

#include <vector>

namespace lancer {

/// Where POV-Ray 3.7 does otherwise by rule, the judge asks what a ray brings by that rule:
/// docs/export.md, "Known differences". The exporter knows what the rules say of its file.
struct PovRayRules {
    /// POV-Ray's unit of length in the scene's: its constants are absolute.
    double unit = 1;
    /// Of the patches, in the order of Scene::patches: each Bezier patch is drawn as 2^h x 2^h x 2
    /// triangles.
    std::vector<int> patch_halvings;
    /// False: the judge's recursion does as Lancer does, and what it brings is our picture, or ours
    /// is wrong.
    bool followed = true;
};

}  // namespace lancer
