// Every block of the language: its table of fields and what it becomes. To add one, declare it
// here, write it in a file of this folder, and add a line to each list in blocks.cpp.
#pragma once

#include "model/shapes.h"
#include "parser/evaluation/block_reader.h"
#include "parser/field.h"

namespace lancer::blocks {

// The scene's own blocks: scene_blocks.cpp
extern const BlockInfo file, image, render, camera;
void make_image(BlockReader& block, std::uint32_t& result);
void make_render(BlockReader& block, std::uint32_t& result);
void make_camera(BlockReader& block, std::uint32_t& result);

// sky.cpp
extern const BlockInfo sky;
void make_sky(BlockReader& block, std::uint32_t& result);

// lights.cpp
extern const BlockInfo point_light, directional_light, spot_light;
void make_point_light(BlockReader& block, std::uint32_t& result);
void make_directional_light(BlockReader& block, std::uint32_t& result);
void make_spot_light(BlockReader& block, std::uint32_t& result);

// solids.cpp
extern const BlockInfo sphere, box, cylinder, cone, torus, plane, triangle;
void make_sphere(BlockReader& block, std::uint32_t& result);
void make_box(BlockReader& block, std::uint32_t& result);
void make_cylinder(BlockReader& block, std::uint32_t& result);
void make_cone(BlockReader& block, std::uint32_t& result);
void make_torus(BlockReader& block, std::uint32_t& result);
void make_plane(BlockReader& block, std::uint32_t& result);
void make_triangle(BlockReader& block, std::uint32_t& result);

// mesh.cpp
extern const BlockInfo mesh;
void make_mesh(BlockReader& block, std::uint32_t& result);

// splines.cpp
extern const BlockInfo patch, lathe, prism;
void make_patch(BlockReader& block, std::uint32_t& result);
void make_lathe(BlockReader& block, std::uint32_t& result);
void make_prism(BlockReader& block, std::uint32_t& result);

// blocks.cpp. Their statements run like those of a file (evaluation/statements.h).
extern const BlockInfo unite, intersect, subtract, group;

// material.cpp
extern const BlockInfo material;
void make_material(BlockReader& block, std::uint32_t& result);

// texture.cpp
extern const BlockInfo texture;
void make_texture(BlockReader& block, std::uint32_t& result);

/// The block in which a script writes each shape of the model.
struct NoBlock {};
template <class AnyShape>
inline constexpr NoBlock block_of{};
template <>
inline constexpr const BlockInfo* block_of<Sphere> = &sphere;
template <>
inline constexpr const BlockInfo* block_of<Box> = &box;
template <>
inline constexpr const BlockInfo* block_of<Cylinder> = &cylinder;
template <>
inline constexpr const BlockInfo* block_of<Cone> = &cone;
template <>
inline constexpr const BlockInfo* block_of<Torus> = &torus;
template <>
inline constexpr const BlockInfo* block_of<Plane> = &plane;
template <>
inline constexpr const BlockInfo* block_of<Triangle> = &triangle;
template <>
inline constexpr const BlockInfo* block_of<MeshRef> = &mesh;
template <>
inline constexpr const BlockInfo* block_of<PatchRef> = &patch;
template <>
inline constexpr const BlockInfo* block_of<LatheRef> = &lathe;
template <>
inline constexpr const BlockInfo* block_of<PrismRef> = &prism;
template <>
inline constexpr const BlockInfo* block_of<CompositeRef> = &unite;  // or `intersect` or `subtract`

}  // namespace lancer::blocks
