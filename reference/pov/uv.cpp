// Images mapped by the shape's own parameters.
#include "reference/pov/pigments.h"

namespace lancer::reference::pov {

void write_uv_pigment(Writer& writer, const Material& material, const ImageTexture& image,
                      const Affine<double>& to_object, const Object& object, PowerOfTen) {
    writer.text.open("pigment {");
    writer.text.line("uv_mapping");
    writer.text.line(image_map(writer, material, image, "map_type 0", object.place));
    const std::string moved = transform(to_object);
    if (!moved.empty()) writer.text.line(moved);
    writer.text.close();
}

}  // namespace lancer::reference::pov
