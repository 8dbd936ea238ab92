// sphere, box, cylinder, cone, torus, plane, triangle.
#include "model/shapes.h"
#include "parser/blocks/attributes.h"
#include "parser/blocks/blocks.h"

namespace lancer::blocks {
namespace {

struct TriangleSpec {
    std::array<Vec3d, 3> points{};
    std::optional<std::array<Vec3d, 3>> normals;
    std::optional<std::array<Vec2d, 3>> uvs;
};

constexpr Field sphere_fields[] = {
    field<&Sphere::center, rules::Vector>("center", "[0, 0, 0]", "its centre"),
    field<&Sphere::radius, rules::Positive>("radius", required, "its radius"),
};
constexpr Field box_fields[] = {
    field<&Box::min, rules::Vector>("min", required, "the corner with the smallest coordinates"),
    field<&Box::max, rules::Vector>("max", required, "the corner with the largest coordinates"),
};
constexpr Field cylinder_fields[] = {
    field<&Cylinder::base, rules::Vector>("base", required, "centre of one end"),
    field<&Cylinder::top, rules::Vector>("top", required, "centre of the other end"),
    field<&Cylinder::radius, rules::Positive>("radius", required, "its radius"),
    field<&Cylinder::capped, rules::Flag>("capped", "true", "false: only the side, without caps"),
};
constexpr Field cone_fields[] = {
    field<&Cone::base, rules::Vector>("base", required, "centre of one end"),
    field<&Cone::top, rules::Vector>("top", required, "centre of the other end"),
    field<&Cone::base_radius, rules::NotNegative>("base_radius", required, "radius at the base"),
    field<&Cone::top_radius, rules::NotNegative>("top_radius", "0", "radius at the top"),
    field<&Cone::capped, rules::Flag>("capped", "true", "false: only the side, without caps"),
};
constexpr Field torus_fields[] = {
    field<&Torus::radius, rules::Positive>("radius", required,
                                           "radius of the circle in the middle of the tube"),
    field<&Torus::tube, rules::Positive>("tube", required,
                                         "radius of the tube, at most that of the circle"),
};
constexpr Field plane_fields[] = {
    field<&Plane::normal, rules::Direction>(
        "normal", required, "perpendicular to the plane, pointing away from its inside"),
    field<&Plane::offset, rules::Number>("offset", "0", "its distance from the origin"),
};
constexpr Field triangle_fields[] = {
    field<&TriangleSpec::points, rules::ThreePoints>("points", required, "its three corners"),
    field<&TriangleSpec::normals, rules::ThreePoints>("normals", "its plane's",
                                                      "normals at the corners, for smooth shading"),
    field<&TriangleSpec::uvs, rules::ThreePlanePoints>("uvs", "none",
                                                       "texture coordinates of the corners"),
};

bool is_degenerate(const std::array<Vec3d, 3>& corners) {
    const std::array<std::uint32_t, 3> all{0, 1, 2};
    std::vector<Mesh::Corners> triangles;
    return !io::triangulate(corners, all, triangles);
}

}  // namespace

const BlockInfo sphere{"sphere", "", sphere_fields, attribute_fields, "a ball"};
const BlockInfo box{"box", "", box_fields, attribute_fields, "a box along the axes"};
const BlockInfo cylinder{"cylinder", "", cylinder_fields, attribute_fields, "a round cylinder"};
const BlockInfo cone{"cone", "", cone_fields, attribute_fields, "a cone, pointed or truncated"};
const BlockInfo torus{"torus", "", torus_fields, attribute_fields,
                      "a ring: a tube bent round the y axis"};
const BlockInfo plane{"plane", "", plane_fields, attribute_fields,
                      "the points p with normal.p = offset |normal|"};
const BlockInfo triangle{"triangle", "", triangle_fields, attribute_fields, "one triangle"};

void make_sphere(BlockReader& block, std::uint32_t&) {
    Sphere made;
    Attributes attributes;
    if (block.read(&made, &attributes)) block.builder().add(made, attributes, block.place());
}

void make_box(BlockReader& block, std::uint32_t&) {
    Box made;
    Attributes attributes;
    if (!block.read(&made, &attributes)) return;
    if (made.max.x < made.min.x || made.max.y < made.min.y || made.max.z < made.min.z) {
        block.error(Message::box_corners, block.place("max"));
        return;
    }
    block.builder().add(made, attributes, block.place());
}

void make_cylinder(BlockReader& block, std::uint32_t&) {
    Cylinder made;
    Attributes attributes;
    if (!block.read(&made, &attributes)) return;
    if (made.base == made.top) {
        block.error(Message::axis_is_point, block.place("top"));
        return;
    }
    block.builder().add(made, attributes, block.place());
}

void make_cone(BlockReader& block, std::uint32_t&) {
    Cone made;
    Attributes attributes;
    if (!block.read(&made, &attributes)) return;
    if (made.base == made.top) block.error(Message::axis_is_point, block.place("top"));
    if (made.base_radius == 0 && made.top_radius == 0)
        block.error(Message::cone_without_radius, block.place("base_radius"));
    if (block.good()) block.builder().add(made, attributes, block.place());
}

void make_torus(BlockReader& block, std::uint32_t&) {
    Torus made;
    Attributes attributes;
    if (!block.read(&made, &attributes)) return;
    if (made.tube > made.radius) {
        block.error(Message::torus_crosses, block.place("tube"), to_text(made.tube),
                    to_text(made.radius));
        return;
    }
    block.builder().add(made, attributes, block.place());
}

void make_plane(BlockReader& block, std::uint32_t&) {
    Plane made;
    Attributes attributes;
    if (block.read(&made, &attributes)) block.builder().add(made, attributes, block.place());
}

void make_triangle(BlockReader& block, std::uint32_t&) {
    TriangleSpec spec;
    Attributes attributes;
    if (!block.read(&spec, &attributes)) return;
    if (is_degenerate(spec.points)) {
        block.warning(Message::degenerate_triangle, block.place());
        return;
    }
    Triangle made{spec.points, none};
    auto& all = block.builder().scene.triangle_attributes;
    if (spec.normals || spec.uvs) {
        made.attributes = static_cast<std::uint32_t>(all.size());
        all.push_back({spec.normals, spec.uvs});
    }
    block.builder().add(made, attributes, block.place());
}

}  // namespace lancer::blocks
