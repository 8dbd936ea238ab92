// The data that the tracer needs to trace a ray by POV-Ray's rules instead of its own.
#pragma once

#include <vector>

namespace lancer {

/// POV-Ray 3.7 has some rules that differ from ours: docs/export.md, "Known differences". The judge
/// asks for the colour of a ray by such a rule. The exporter knows these values for its file.
struct PovRayRules {
    /// POV-Ray's unit of length in units of the scene. POV-Ray's constants are absolute lengths.
    double unit = 1;
    /// h for each patch, in the order of Scene::patches: POV-Ray draws each Bezier patch as
    /// 2^h x 2^h x 2 triangles.
    std::vector<int> patch_halvings;
    /// False: the judge's recursion uses Lancer's rules. Its colours must then be those of our
    /// picture.
    bool followed = true;
};

}  // namespace lancer
