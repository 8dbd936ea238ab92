// What the parts of the exporter share: the scene, the scale, and the result that grows.
#pragma once

#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "reference/pov/export.h"
#include "reference/pov/text.h"

namespace lancer::reference::pov {

using TextureKey =
    std::pair<std::uint32_t, int>;  ///< material; size against the scene's, in decades
/// Mesh, space, whether smooth, whether in pieces; the material whose colours its vertices have;
/// what its author says of its inside.
using MeshKey = std::tuple<std::uint32_t, int, bool, bool, std::uint32_t, Inside>;

struct Writer {
    const Scene& scene;
    const ExportView& view;
    const ExportOptions& options;
    ExportResult& result;
    PowerOfTen scale;
    Text text;

    std::map<std::uint32_t, std::string> image_words;  ///< by index: `png "a.png" gamma srgb`
    std::map<TextureKey, std::string> texture_names;
    std::map<MeshKey, std::string> mesh_names;
    std::vector<std::vector<std::uint32_t>> merged{};  ///< objects that are one body each
    bool in_composite = false;                         ///< what is being written needs its inside

    /// Something POV-Ray has no word for, at its place in the script.
    void refuse(const SourceSpan& where, const std::string& message, const std::string& hint = "");
    void approximate(const SourceSpan& where, const std::string& explanation);
    Color lit(const Color& color) const { return color * options.exposure; }
};

// One file each: the parts of a `.pov`, top to bottom.
void write_header(Writer& writer);
void write_global_settings(Writer& writer);
void write_camera(Writer& writer);
void write_light(Writer& writer, const Light& light);
void declare_textures(Writer& writer);
void write_object(Writer& writer, std::uint32_t index);
/// Bodies of one glass as one.
void write_merged(Writer& writer, const std::vector<std::uint32_t>& members);

}  // namespace lancer::reference::pov
