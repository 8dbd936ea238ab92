// The state that the parts of the exporter share: the scene, the scale, and the growing result.
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
/// The mesh, its space, whether smooth, whether in pieces; the material with its vertex colours;
/// the inside that the script declares.
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
    bool in_composite = false;  ///< the object that is being written needs its inside

    /// Reports a feature that POV-Ray does not have, at its place in the script.
    void refuse(const SourceSpan& where, const std::string& message, const std::string& hint = "");
    void approximate(const SourceSpan& where, const std::string& explanation);
    Color lit(const Color& color) const { return color * options.exposure; }
};

// The parts of a `.pov` from top to bottom, each in a file of its own.
void write_header(Writer& writer);
void write_global_settings(Writer& writer);
void write_camera(Writer& writer);
void write_light(Writer& writer, const Light& light);
void declare_textures(Writer& writer);
void write_object(Writer& writer, std::uint32_t index);
/// Writes glued bodies of the same glass as one.
void write_merged(Writer& writer, const std::vector<std::uint32_t>& members);

}  // namespace lancer::reference::pov
