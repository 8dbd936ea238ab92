// What stands for the surface's colour: plain, checker, gradient, image.
#pragma once

#include "reference/pov/writer.h"

namespace lancer::reference::pov {

/// `pigment { … }` of an object that shows the material. Only an image mapped by uv asks for more
/// of it than its place. `own` scales the object's own space.
void write_pigment(Writer& writer, const Material& material, const Object& object, PowerOfTen own);

/// `pigment { … }` of one colour, through which passes what passes through the material.
std::string plain_pigment(const Color& color, const Material& material);

/// A texture's own transforms in an object's space scaled by `own`, as words of a pigment.
std::string pattern_transform(const Affine<double>& to_object, PowerOfTen own);

/// `image_map { png "…" … }` for a material that shows this image; `words` are put in front of the
/// closing brace (map_type).
std::string image_map(Writer& writer, const Material& material, const ImageTexture& image,
                      const std::string& words, const SourceSpan& where);

/// The whole of `pigment { … }` for an image mapped by the uv of one shape.
void write_uv_pigment(Writer& writer, const Material& material, const ImageTexture& image,
                      const Affine<double>& to_object, const Object& object, PowerOfTen own);

}  // namespace lancer::reference::pov
