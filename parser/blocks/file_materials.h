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
    SourceSpan place{};  ///< of the file's name
};

/// What the mesh becomes. Where the scene has a material for it, that is the mesh, and the file's
/// materials are not looked at. Elsewhere the libraries and images are read, which may warn at
/// `place`, and each material is given the faces that have it. Uses the context when it is
/// called.
MakeParts parts_of(const BlockContext& context, const MeshWithMaterials& whole);

/// A material of MTL in the terms of this language; `textured`: an image stands for its colour.
Material material_of(const io::MtlMaterial& from, bool textured);

/// Where the scene holds this mesh; it is added when it is not there.
std::uint32_t mesh_index(SceneBuilder& builder, const std::shared_ptr<const Mesh>& mesh);

}  // namespace lancer
