// Writes shapes as POV-Ray's own primitives.
#pragma once

#include "reference/pov/export_scale.h"
#include "reference/pov/writer.h"

namespace lancer::reference::pov {

/// Opens the shape's block and writes its geometry, scaled by `own`. The caller adds texture,
/// interior and transforms, and closes the block. False when the shape was refused.
bool open_shape(Writer& writer, const Object& object, PowerOfTen own);

// These have files of their own because they are longer.
bool open_mesh(Writer& writer, const Object& object, const MeshRef& shape, PowerOfTen own);
bool open_triangle(Writer& writer, const Object& object, const Triangle& shape, PowerOfTen own);
bool open_patch(Writer& writer, const Object& object, const Patch& patch, PowerOfTen own);
bool open_lathe(Writer& writer, const Lathe& lathe, PowerOfTen own);
bool open_prism(Writer& writer, const Prism& prism, PowerOfTen own);

/// Whether the mesh has texture coordinates at each corner of each face.
bool is_mapped(const Mesh& mesh);

/// Declares a mesh once for all objects that use it, before the first of them.
void declare_mesh(Writer& writer, const Object& object, PowerOfTen own);

}  // namespace lancer::reference::pov
