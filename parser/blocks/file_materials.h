// The materials of an OBJ file as materials of the scene, and its mesh as one object for each.
#pragma once

#include <memory>
#include <string>

#include "model/io/mesh_file.h"
#include "model/io/mtl_reader.h"
#include "model/scene.h"
#include "parser/evaluation/block_context.h"
#include "parser/scene_builder.h"

namespace lancer {

/// A mesh whose file names materials.
struct MeshWithMaterials {
    std::shared_ptr<const io::LoadedMesh> loaded;
    std::string path;
    std::shared_ptr<const Mesh> mesh;  ///< of `loaded`, or a copy of it with normals
    bool smooth = true;
    Inside inside = Inside::if_closed;
    SourceSpan place{};  ///< the place of the file's name
};

/// The objects that the mesh becomes. If the scene gives it a material, that is one mesh, and the
/// file's materials are ignored. Otherwise the material libraries and images are read, which may
/// warn at `place`, and the faces of each material become a mesh. The result uses `context` when it
/// is called.
MakeParts parts_of(const BlockContext& context, const MeshWithMaterials& whole);

/// Converts a material of MTL to the terms of this language. `textured`: an image replaces its
/// colour.
Material material_of(const io::MtlMaterial& from, bool textured);

/// The index of this mesh in the scene. Adds the mesh when it is not there.
std::uint32_t mesh_index(SceneBuilder& builder, const std::shared_ptr<const Mesh>& mesh);

}  // namespace lancer
