// Materials as textures and interiors.
#pragma once

#include <string>

#include "reference/pov/writer.h"

namespace lancer::reference::pov {

/// Whether anything passes through a surface of this material.
bool lets_light_pass(const Scene& scene, const Material& material);

/// Whether the pattern depends on the shape that shows it, so that no declared texture can serve.
bool depends_on_shape(const Scene& scene, const Material& material);

/// Whether a mesh shows the colours of its vertices.
bool is_of_vertices(const Scene& scene, const Material& material);

/// `texture_list { … }` of a mesh: the material in each of these colours.
void write_vertex_textures(Writer& writer, const Material& material,
                           const std::vector<Color>& colors);

/// The image texture that the material shows, or null: none, or textures are switched off.
const Texture* texture_of(const Scene& scene, const Material& material);

/// `texture { … }` of an object whose own space is scaled by `own`: a declared one, or one of its
/// own.
///
/// \param moved  a transform of the texture alone; may be empty
void write_texture(Writer& writer, const Object& object, PowerOfTen own,
                   const std::string& moved = "");

/// The leaf, in the place that its texture has; where that is the shape's own, or there is no
/// texture, in its own place.
Object texture_holder(const Scene& scene, const Composite::Leaf& leaf);

/// `interior { … }` for what lets light pass, or mirrors by Fresnel's equations. A sheet that light
/// passes has no inside: POV-Ray would never find the way out of it, so its ior is 1.
///
/// \param passes  whether light passes some surface of the object
void write_interior(Writer& writer, const Material& material, bool body, bool passes);

}  // namespace lancer::reference::pov
