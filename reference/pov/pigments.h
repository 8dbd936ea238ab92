// Writes the surface's colour: plain, checker, gradient, image.
#pragma once

#include "reference/pov/writer.h"

namespace lancer::reference::pov {

/// `pigment { … }` of an object with this material. Only an image mapped by uv depends on more of
/// the object than its transform. `own` scales the object's own space.
void write_pigment(Writer& writer, const Material& material, const Object& object, PowerOfTen own);

/// `pigment { … }` of one colour, with the transmission of the material.
std::string plain_pigment(const Color& color, const Material& material);

/// The transforms of a texture in an object's space scaled by `own`, for a pigment.
std::string pattern_transform(const Affine<double>& to_object, PowerOfTen own);

/// `image_map { png "…" … }` for a material with this image; `words` are written before the closing
/// brace (map_type).
std::string image_map(Writer& writer, const Material& material, const ImageTexture& image,
                      const std::string& words, const SourceSpan& where);

/// The complete `pigment { … }` for an image mapped by the uv coordinates of a shape.
void write_uv_pigment(Writer& writer, const Material& material, const ImageTexture& image,
                      const Affine<double>& to_object, const Object& object, PowerOfTen own);

}  // namespace lancer::reference::pov
