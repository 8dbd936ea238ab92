// Writes materials as textures and interiors.
#pragma once

#include <string>

#include "reference/pov/writer.h"

namespace lancer::reference::pov {

/// Whether light passes through surfaces of this material.
bool lets_light_pass(const Scene& scene, const Material& material);

/// Whether the pattern depends on the shape, so that a declared texture cannot be used.
bool depends_on_shape(const Scene& scene, const Material& material);

/// Whether a mesh shows the colours of its vertices.
bool is_of_vertices(const Scene& scene, const Material& material);

/// `texture_list { … }` of a mesh: the material once for each of these colours.
void write_vertex_textures(Writer& writer, const Material& material,
                           const std::vector<Color>& colors);

/// The image texture of the material; null when there is none or textures are switched off.
const Texture* texture_of(const Scene& scene, const Material& material);

/// `texture { … }` of an object whose own space is scaled by `own`: a reference to a declared
/// texture, or a texture of its own.
///
/// \param moved  a transform of the texture alone; may be empty
void write_texture(Writer& writer, const Object& object, PowerOfTen own,
                   const std::string& moved = "");

/// The leaf with the transform of its texture. When the texture belongs to the shape's own space,
/// or there is none, the leaf keeps its transform.
Object texture_holder(const Scene& scene, const Composite::Leaf& leaf);

/// `interior { … }` for surfaces that transmit light or mirror by Fresnel's equations. A
/// transparent sheet has no inside: POV-Ray would never find the exit, so its ior is 1.
///
/// \param passes  whether light passes through any surface of the object
void write_interior(Writer& writer, const Material& material, bool body, bool passes);

}  // namespace lancer::reference::pov
