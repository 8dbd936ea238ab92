#include "parser/blocks/blocks.h"

#include <type_traits>
#include <variant>
#include <vector>

#include "parser/blocks/attributes.h"

namespace lancer {
namespace blocks {

const BlockInfo unite{
    "union", "", {}, attribute_fields, "one body made of several: everything inside any of them",
    true};
const BlockInfo intersect{"intersection",
                          "",
                          {},
                          attribute_fields,
                          "one body made of several: everything inside all of them",
                          true};
const BlockInfo subtract{
    "difference", "", {}, attribute_fields, "one body: the first minus all others", true};

const BlockInfo group{
    "group", "", {}, attribute_fields, "objects, lights and statements that share transforms",
    true};

}  // namespace blocks

namespace {

template <class... Shapes>
constexpr bool all_have_blocks(std::type_identity<std::variant<Shapes...>>) {
    return (std::is_pointer_v<decltype(blocks::block_of<Shapes>)> && ...);
}
static_assert(all_have_blocks(std::type_identity<Shape>{}),
              "every alternative of lancer::Shape needs a block: parser/blocks/blocks.h");

struct Entry {
    const BlockInfo* info;
    MakeBlock make;
};

/// In the order of the manual.
constexpr Entry entries[] = {
    {&blocks::file, nullptr},
    {&blocks::image, blocks::make_image},
    {&blocks::render, blocks::make_render},
    {&blocks::camera, blocks::make_camera},
    {&blocks::sky, blocks::make_sky},
    {&blocks::point_light, blocks::make_point_light},
    {&blocks::directional_light, blocks::make_directional_light},
    {&blocks::spot_light, blocks::make_spot_light},
    {&blocks::sphere, blocks::make_sphere},
    {&blocks::box, blocks::make_box},
    {&blocks::cylinder, blocks::make_cylinder},
    {&blocks::cone, blocks::make_cone},
    {&blocks::torus, blocks::make_torus},
    {&blocks::plane, blocks::make_plane},
    {&blocks::triangle, blocks::make_triangle},
    {&blocks::mesh, blocks::make_mesh},
    {&blocks::patch, blocks::make_patch},
    {&blocks::lathe, blocks::make_lathe},
    {&blocks::prism, blocks::make_prism},
    {&blocks::unite, nullptr},
    {&blocks::intersect, nullptr},
    {&blocks::subtract, nullptr},
    {&blocks::group, nullptr},
    {&blocks::material, blocks::make_material},
    {&blocks::texture, blocks::make_texture},
};

}  // namespace

std::span<const BlockInfo> all_blocks() {
    static const std::vector<BlockInfo> all = [] {
        std::vector<BlockInfo> list;
        for (const Entry& entry : entries) list.push_back(*entry.info);
        return list;
    }();
    return all;
}

MakeBlock maker_of(const BlockInfo& block) {
    return entries[static_cast<std::size_t>(&block - all_blocks().data())].make;
}

}  // namespace lancer
