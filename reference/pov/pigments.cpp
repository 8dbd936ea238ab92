#include "reference/pov/pigments.h"

#include <fmt/format.h>

#include "model/plain_color.h"
#include "reference/pov/choices.h"
#include "reference/pov/images.h"
#include "reference/pov/materials.h"

namespace lancer::reference::pov {

namespace {

/// Three numbers for an opaque colour; otherwise POV-Ray's five: with filter, then transmit.
std::string pigment_color(const Color& color, const Material& material) {
    if (!(material.filter + material.transmission > 0)) return rgb(color);
    return fmt::format("rgbft <{}, {}, {}, {}, {}>", number(color.x), number(color.y),
                       number(color.z), number(material.filter), number(material.transmission));
}

struct PatternWriter {
    Writer& writer;
    const Material& material;
    const Object& object;
    PowerOfTen own;
    const Affine<double>& to_object;

    void operator()(const Checker& checker) const {
        writer.text.open("pigment {");
        writer.text.line("checker " + pigment_color(checker.even, material) + ", " +
                         pigment_color(checker.odd, material));
        end();
    }

    void operator()(const Gradient& gradient) const {
        if (gradient.stops.size() > 256)
            writer.refuse(object.place, "POV-Ray's colour maps hold at most 256 stops");
        writer.text.open("pigment {");
        const Vec3d axis = normalize(gradient.axis);
        writer.text.line("gradient " + vector(axis));
        writer.text.open("color_map {");
        for (const Gradient::Stop& stop : gradient.stops)
            writer.text.line("[" + number(stop.at) + " " + pigment_color(stop.color, material) +
                             "]");
        writer.text.close();
        // POV-Ray repeats with a period of 1.00001 where the coordinate is negative, so the pattern
        // is moved by a million whole periods. A billionth more decides the side for a face that
        // lies exactly on a step, where rounding would cause speckles.
        writer.text.line("translate " + vector(-axis * periods) +
                         "  // whole periods: keeps coordinates positive");
        end();
    }

    void operator()(const VertexColors&) const {}  // write_vertex_textures()

    void operator()(const ImageTexture& image) const {
        const SourceSpan where = object.place;
        if (image.mapping == ImageTexture::Mapping::uv) {
            write_uv_pigment(writer, material, image, to_object, object, own);
            return;
        }
        const char* type = image.mapping == ImageTexture::Mapping::planar      ? "map_type 0"
                           : image.mapping == ImageTexture::Mapping::spherical ? "map_type 1"
                                                                               : "map_type 2";
        writer.text.open("pigment {");
        writer.text.line(image_map(writer, material, image, type, where));
        end();
    }

    void end() const {
        const std::string moved = pattern_transform(to_object, own);
        if (!moved.empty()) writer.text.line(moved);
        writer.text.close();
    }
};

}  // namespace

std::string pattern_transform(const Affine<double>& to_object, PowerOfTen own) {
    Affine<double> map = to_object;
    for (Vec3d& row : map.rows) row = own(row);
    map.shift = own(map.shift);
    return transform(map);
}

std::string image_map(Writer& writer, const Material& material, const ImageTexture& image,
                      const std::string& words, const SourceSpan& where) {
    std::string out = "image_map { " + image_file_words(writer, image.image, where) + " " + words;
    if (image.filter == ImageTexture::Filter::bilinear) out += " interpolate 2";
    if (image.wrap == ImageTexture::Wrap::once) out += " once";
    // An image with alpha has its own transmission; the material's is ignored.
    if (writer.scene.images[image.image].pixels->channels != 4) {
        if (material.filter > 0) out += " filter all " + number(material.filter);
        if (material.transmission > 0) out += " transmit all " + number(material.transmission);
    }
    return out + " }";
}

std::string plain_pigment(const Color& color, const Material& material) {
    return "pigment { " + pigment_color(color, material) + " }";
}

void write_pigment(Writer& writer, const Material& material, const Object& object, PowerOfTen own) {
    const Texture* texture = texture_of(writer.scene, material);
    if (!texture) {
        writer.text.line(plain_pigment(plain_color(writer.scene, material), material));
        return;
    }
    std::visit(PatternWriter{writer, material, object, own, texture->to_object}, texture->pattern);
}

}  // namespace lancer::reference::pov
