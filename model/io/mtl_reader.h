// Reads Wavefront MTL: the materials of an OBJ file.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/math.h"

namespace lancer::io {

/// A material as in the file; values that the file does not give are empty.
struct MtlMaterial {
    std::string name;
    std::optional<Color> ambient, diffuse, specular, emission;  ///< Ka, Kd, Ks, Ke
    std::optional<double> shininess;                            ///< Ns
    std::optional<double> ior;                                  ///< Ni
    std::optional<double> opacity;                              ///< d, or 1 - Tr
    std::optional<int> illumination;                            ///< illum, 0 to 10
    std::string image;  ///< map_Kd, relative to the file's folder; empty: none
};

struct MtlFile {
    std::vector<MtlMaterial> materials;
    /// Statements and options that are skipped, each once, as "map_Bump (line 7)".
    std::vector<std::string> skipped;
};

/// Reads Kd, Ka, Ks, Ke, Ns, Ni, d, Tr, illum and map_Kd (Wavefront, Advanced Visualizer manual,
/// appendix B2; Ke is a common extension). Numbers outside of a statement's range are clamped.
/// Throws FileError, which names `name` and the line, for an invalid or non-finite number, and for
/// a statement before the first `newmtl`.
MtlFile read_mtl(std::string_view bytes, const std::string& name);

}  // namespace lancer::io
