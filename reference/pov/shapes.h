// Shapes as POV-Ray's own primitives.
#pragma once

#include "reference/pov/export_scale.h"
#include "reference/pov/writer.h"

namespace lancer::reference::pov {

/// Opens the shape's block and writes its geometry, scaled by `own`; the caller adds texture,
/// interior and transforms and closes the block. False when the shape was refused.
bool open_shape(Writer& writer, const Object& object, PowerOfTen own);

// Their own files, because there is more to say.
bool open_mesh(Writer& writer, const Object& object, const MeshRef& shape, PowerOfTen own);
bool open_triangle(Writer& writer, const Object& object, const Triangle& shape, PowerOfTen own);
bool open_patch(Writer& writer, const Object& object, const Patch& patch, PowerOfTen own);
bool open_lathe(Writer& writer, const Lathe& lathe, PowerOfTen own);
bool open_prism(Writer& writer, const Prism& prism, PowerOfTen own);

/// Whether the mesh says for each corner of each face where in an image it lies.
bool is_mapped(const Mesh& mesh);

/// Meshes are declared once for all objects that show them, before the first of these.
void declare_mesh(Writer& writer, const Object& object, PowerOfTen own);

}  // namespace lancer::reference::pov
