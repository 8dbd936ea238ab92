// Which faces coincide, and how the exporter tells them apart when asked to.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reference/pov/export_scale.h"
#include "reference/pov/resolution.h"
#include "tests/reference/pov/scene_kit.h"

namespace lancer::reference {
namespace {

using Resolution = Coincidence::Resolution;
using testing::HasSubstr;
using testing::Not;

Material clear(double ior) {
    Material m;
    m.transmission = 0.9;
    m.ior = ior;
    return m;
}

/// The resolutions of a scene's pairs, by objects.
std::vector<Resolution> resolutions(const Scene& scene) {
    std::vector<Resolution> out;
    for (const Coincidence& c : export_pov(scene, {0, 64, 48}).coincidences)
        out.push_back(c.resolution);
    return out;
}

/// The bottom of an object's box after the resolution by steps of 0.001.
double bottom_of(const Scene& scene, std::uint32_t object) {
    const pov::ResolvedScene told = pov::resolved(scene, pov::face_pairs(scene), 0.001);
    const Object& shown = told.scene.objects[object];
    return pov::moved(told.scene.transforms[shown.transform],
                      *pov::shape_bounds(told.scene, shown.shape))
        .low.y;
}

bool all_are_told(const pov::ResolvedScene& told) {
    return !told.pairs.empty() &&
           std::none_of(told.pairs.begin(), told.pairs.end(),
                        [](const auto& p) { return p.resolution == Resolution::none; });
}

TEST(Coincidences, AreNamedWithBothObjectsAndByWhatTheyAre) {
    Scene scene = empty_scene();
    const std::uint32_t glass = add_material(scene, clear(1.5));
    const std::uint32_t water = add_material(scene, clear(1.33));
    add_object(scene, Plane{{0, 1, 0}, 0});
    add_object(scene, Box{{0, 0, 0}, {1, 1, 1}}, glass);
    add_object(scene, Box{{1, 0.1, 0.1}, {2, 0.9, 0.9}}, glass);
    add_object(scene, Box{{0.1, 1, 0.1}, {0.9, 2, 0.9}}, water);
    add_object(scene, Box{{-1, 0, 3}, {0, 1, 4}});
    const auto found = export_pov(scene, {0, 64, 48}).coincidences;
    ASSERT_EQ(found.size(), 4u);
    const auto is = [](const Coincidence& c, std::uint32_t a, std::uint32_t b, Resolution r) {
        return c.first == a && c.second == b && c.resolution == r;
    };
    EXPECT_TRUE(is(found[0], 0, 1, Resolution::sunk));
    EXPECT_TRUE(is(found[1], 0, 4, Resolution::hidden));
    EXPECT_TRUE(is(found[2], 1, 2, Resolution::merged));
    EXPECT_TRUE(is(found[3], 1, 3, Resolution::overlapped));
}

TEST(Coincidences, OfFacesThatLookTheSameWay) {
    Scene scene = empty_scene();
    const std::uint32_t glass = add_material(scene, clear(1.5));
    add_object(scene, Box{{0, 0, 0}, {2, 1, 2}});
    add_object(scene, Box{{0.5, 0.5, 0.5}, {1.5, 1, 1.5}});
    EXPECT_THAT(resolutions(scene), testing::ElementsAre(Resolution::in_front));
    scene.objects[0].material = glass;
    EXPECT_THAT(resolutions(scene), testing::ElementsAre(Resolution::in_front));
    scene.objects[1].material = glass;
    EXPECT_THAT(resolutions(scene), testing::ElementsAre(Resolution::none));
}

TEST(Coincidences, OfSheets) {
    Scene scene = empty_scene();
    const std::uint32_t glass = add_material(scene, clear(1.5));
    add_object(scene, Box{{0, 0, 0}, {1, 1, 1}});
    add_object(scene, Triangle{{Vec3d(0, 1, 0), Vec3d(1, 1, 0), Vec3d(0, 1, 1)}});
    EXPECT_THAT(resolutions(scene), testing::ElementsAre(Resolution::in_front));
    scene.objects[0].material = glass;
    EXPECT_THAT(resolutions(scene), testing::ElementsAre(Resolution::sunk));
    scene.objects[1].material = glass;
    EXPECT_THAT(resolutions(scene), testing::ElementsAre(Resolution::none));
    scene.objects[0].shape = Triangle{{Vec3d(0, 1, 0), Vec3d(1, 1, 0), Vec3d(1, 1, 1)}};
    EXPECT_THAT(resolutions(scene), testing::ElementsAre(Resolution::none));
}

TEST(Coincidences, OfRoundSides) {
    Scene scene = empty_scene();
    const std::uint32_t glass = add_material(scene, clear(1.5));
    const std::uint32_t water = add_material(scene, clear(1.33));
    scene.lathes.push_back(
        {{{0, 0}, {0.8, 0}, {0.8, 2}, {0.7, 2}, {0.7, 0.1}, {0, 0.1}}, Spline::linear, {}});
    add_object(scene, LatheRef{0}, glass);
    add_object(scene, Cylinder{{0, 0.2, 0}, {0, 1, 0}, 0.7}, water);
    EXPECT_THAT(resolutions(scene), testing::ElementsAre(Resolution::overlapped));
    scene.objects[1].shape = Cylinder{{0, 0.2, 0}, {0, 1, 0}, 0.69};
    EXPECT_TRUE(resolutions(scene).empty());
    // The same side, seen from inside and outside.
    scene.objects[1].shape = Cylinder{{0, 0.2, 0}, {0, 1, 0}, 0.8};
    EXPECT_THAT(resolutions(scene), testing::ElementsAre(Resolution::none));
    scene.objects[0].shape = Sphere{{1, 2, 3}, 2};
    scene.objects[1].shape = Sphere{{1, 2, 3}, 2};
    EXPECT_THAT(resolutions(scene), testing::ElementsAre(Resolution::none));
}

TEST(Coincidences, NeedAnAreaAndNotAnEdge) {
    Scene scene = empty_scene();
    add_object(scene, Box{{0, 0, 0}, {1, 1, 1}});
    add_object(scene, Box{{1, 1, 0}, {2, 2, 1}});
    EXPECT_TRUE(resolutions(scene).empty());
    // Glued: their tops lie in one plane and share an edge, which leans.
    scene.objects[1].shape = Box{{1, 0, 0}, {2, 1, 1}};
    Affine<double> lean;
    lean.rows = {Vec3d(0.6, -0.8, 0), Vec3d(0.8, 0.6, 0), Vec3d(0, 0, 1)};
    scene.objects[0].transform = scene.objects[1].transform = add_transform(scene, lean);
    EXPECT_THAT(resolutions(scene), testing::ElementsAre(Resolution::hidden));
}

TEST(Resolution, SinksAClearBodyIntoWhatItStandsOn) {
    Scene scene = empty_scene();
    const std::uint32_t glass = add_material(scene, clear(1.5));
    add_object(scene, Plane{{0, 1, 0}, 0});
    add_object(scene, Box{{0, 0, 0}, {1, 1, 1}}, glass);
    EXPECT_NEAR(bottom_of(scene, 1), -0.001, 1e-9);
    scene.objects[1].material = 0;
    EXPECT_EQ(bottom_of(scene, 1), 0) << "opaque on opaque asks for nothing";
}

TEST(Resolution, LeavesABodyThinnerThanAStepAlone) {
    // A bent sheet in front cannot move, so the faces that it covers move inwards.
    const auto told_of = [](Shape covered) {
        Scene scene = empty_scene();
        Mesh sheet;
        sheet.vertices = {{0, 0, 0}, {0.5, 0, 0}, {0, 0, 0.5}, {5, 0, 0}, {5, 1, 0}, {5, 0, 1}};
        sheet.faces = {{0, 1, 2}, {3, 4, 5}};
        scene.meshes.push_back(std::make_shared<const Mesh>(std::move(sheet)));
        add_object(scene, MeshRef{0});
        add_object(scene, std::move(covered));
        add_object(scene, Box{{4, 0, 0}, {5, 1, 1}});
        return pov::resolved(scene, pov::face_pairs(scene), 0.001);
    };
    const auto thick = told_of(Box{{-1, 0, -1}, {1, 0.005, 1}});
    EXPECT_TRUE(all_are_told(thick));
    EXPECT_NEAR(std::get<Box>(thick.scene.objects[1].shape).min.y, 0.001, 1e-9);
    const auto thin = told_of(Box{{-1, 0, -1}, {1, 0.0005, 1}});
    EXPECT_EQ(std::get<Box>(thin.scene.objects[1].shape).min.y, 0);
    EXPECT_FALSE(all_are_told(thin));
    const auto disc = told_of(Cylinder{{0, 0, 0}, {0, 0.0005, 0}, 1});
    EXPECT_EQ(std::get<Cylinder>(disc.scene.objects[1].shape).base.y, 0);
    EXPECT_FALSE(all_are_told(disc));
    const auto cone = told_of(Cone{{0, 0, 0}, {0, 0.0005, 0}, 1, 0.5});
    EXPECT_EQ(std::get<Cone>(cone.scene.objects[1].shape).base.y, 0);
    EXPECT_FALSE(all_are_told(cone));
}

TEST(Resolution, MovesTheTableWhereTheBodyCannotGrow) {
    // Growing a tumbler about its centre would pull its inner wall away from the water.
    Scene scene = empty_scene();
    const std::uint32_t glass = add_material(scene, clear(1.5));
    const std::uint32_t water = add_material(scene, clear(1.33));
    scene.lathes.push_back(
        {{{0, 0}, {0.8, 0}, {0.8, 2}, {0.7, 2}, {0.7, 0.1}, {0, 0.1}}, Spline::linear, {}});
    add_object(scene, Plane{{0, 1, 0}, 0});
    add_object(scene, LatheRef{0}, glass);
    add_object(scene, Cylinder{{0, 0.1, 0}, {0, 1, 0}, 0.7}, water);
    const auto pairs = pov::face_pairs(scene);
    const pov::ResolvedScene told = pov::resolved(scene, pairs, 0.001);
    EXPECT_TRUE(all_are_told(told));
    const auto moves = [&](std::uint32_t i) { return told.scene.objects[i].transform != 0; };
    EXPECT_TRUE(moves(0));
    EXPECT_FALSE(moves(1));
    EXPECT_NEAR(std::get<Cylinder>(told.scene.objects[2].shape).radius, 0.701, 1e-9);
    EXPECT_NEAR(told.scene.transforms[told.scene.objects[0].transform].shift.y, 0.001, 1e-12);
}

TEST(Resolution, MergesOneGlass) {
    Scene scene = empty_scene();
    const std::uint32_t glass = add_material(scene, clear(1.5));
    add_object(scene, Box{{0, 0, 0}, {1, 1, 1}}, glass);
    add_object(scene, Box{{1, 0, 0}, {2, 1, 1}}, glass);
    add_object(scene, Sphere{{0, 5, 0}, 1}, glass);
    const std::string told = export_pov(scene, {0, 64, 48}, {.resolve_coincidences = true}).text;
    EXPECT_THAT(told, HasSubstr("merge {"));
    EXPECT_THAT(export_pov(scene, {0, 64, 48}).text, Not(HasSubstr("merge {")));
    const std::size_t merged = told.find("merge {");
    EXPECT_LT(merged, told.find("sphere {"));
    const auto interiors = [](std::string_view text) {
        std::size_t n = 0;
        for (std::size_t at = text.find("interior {"); at != std::string_view::npos;
             at = text.find("interior {", at + 1))
            ++n;
        return n;
    };
    EXPECT_EQ(interiors(told), 2u) << "one of both boxes";
    scene.objects[1].casts_shadow = false;
    EXPECT_THAT(resolutions(scene), testing::ElementsAre(Resolution::none));
}

TEST(Resolution, PutsTheFirstDeclaredInFront) {
    Scene scene = empty_scene();
    add_object(scene, Box{{0, 0, 0}, {2, 1, 2}});
    add_object(scene, Box{{0.5, 0.5, 0.5}, {1.5, 1, 1.5}});
    const auto top_of = [](const pov::ResolvedScene& told, std::uint32_t i) {
        const Object& shown = told.scene.objects[i];
        return pov::moved(told.scene.transforms[shown.transform],
                          *pov::shape_bounds(told.scene, shown.shape))
            .high.y;
    };
    pov::ResolvedScene told = pov::resolved(scene, pov::face_pairs(scene), 0.001);
    EXPECT_NEAR(top_of(told, 0) - top_of(told, 1), 0.001, 1e-9);
    std::swap(scene.objects[0], scene.objects[1]);
    told = pov::resolved(scene, pov::face_pairs(scene), 0.001);
    EXPECT_NEAR(top_of(told, 0) - top_of(told, 1), 0.001, 1e-9);
}

TEST(Resolution, OfAPileIsAPile) {
    // Each is in front of the one before: three coincident tops.
    Scene scene = empty_scene();
    for (int i = 0; i < 3; ++i)
        add_object(scene, Box{{0.1 * i, 0, 0.1 * i}, {2 - 0.1 * i, 1, 2 - 0.1 * i}});
    const pov::ResolvedScene told = pov::resolved(scene, pov::face_pairs(scene), 0.001);
    EXPECT_TRUE(all_are_told(told));
}

TEST(Resolution, SinksAGlassRodIntoTheWallOfItsHole) {
    Scene scene = empty_scene();
    const std::uint32_t glass = add_material(scene, clear(1.5));
    add_composite(scene, Composite::Kind::subtract, Box{{-1, 0, -1}, {1, 1, 1}},
                  Cylinder{{0, 0, 0}, {0, 1, 0}, 0.5});
    add_object(scene, Cylinder{{0, -1, 0}, {0, 2, 0}, 0.5}, glass);
    EXPECT_THAT(resolutions(scene), testing::ElementsAre(Resolution::in_front, Resolution::sunk));
    const pov::ResolvedScene told = pov::resolved(scene, pov::face_pairs(scene), 0.001);
    EXPECT_TRUE(all_are_told(told));
    const auto rod = [](const Object& object) { return std::get<Cylinder>(object.shape); };
    const Cylinder hole = rod(told.scene.composites[0].leaves[1].object);
    EXPECT_NEAR(hole.base.y, -0.001, 1e-9);
    EXPECT_NEAR(hole.top.y, 1.001, 1e-9);
    EXPECT_NEAR(hole.radius, 0.499, 1e-9) << "its wall is sunk into the glass";
    EXPECT_EQ(rod(told.scene.objects[1]).radius, 0.5);
    // Then it stands on the block and over the end of the hole, where nothing is.
    scene.objects[1].shape = Cylinder{{0, 1, 0}, {0, 2, 0}, 0.5};
    EXPECT_THAT(
        resolutions(scene),
        testing::UnorderedElementsAre(Resolution::in_front, Resolution::sunk, Resolution::hidden));
    // An opaque rod in glass: the wall again.
    std::swap(scene.composites[0].leaves[0].object.material, scene.objects[1].material);
    scene.objects[1].shape = Cylinder{{0, -1, 0}, {0, 2, 0}, 0.5};
    scene.composites[0].leaves[1].object.material = glass;
    const pov::ResolvedScene turned = pov::resolved(scene, pov::face_pairs(scene), 0.001);
    EXPECT_TRUE(all_are_told(turned));
    EXPECT_NEAR(rod(turned.scene.composites[0].leaves[1].object).radius, 0.499, 1e-9);
}

TEST(Resolution, MovesEndsAndSidesOneByOneWhateverTheMap) {
    Scene scene = empty_scene();
    Affine<double> map;
    map.rows = {Vec3d(0, -2, 0), Vec3d(2, 0, 0), Vec3d(0, 0, 2)};  // twice as large, turned about z
    const std::uint32_t turned = add_transform(scene, map);
    add_composite(scene, Composite::Kind::subtract, Box{{-1, -1, -1}, {1, 1, 1}},
                  Cone{{0, 0, 0}, {1, 0, 0}, 0.2, 0.4}, 0, turned);
    const pov::ResolvedScene told = pov::resolved(scene, pov::face_pairs(scene), 0.001);
    EXPECT_TRUE(all_are_told(told));
    const Cone cone = std::get<Cone>(told.scene.composites[0].leaves[1].object.shape);
    EXPECT_EQ(cone.base.x, 0);
    EXPECT_NEAR(cone.top.x, 1.0005, 1e-9);
    EXPECT_NEAR(cone.top_radius, 0.4001, 1e-9) << "its side stays where it is";
    EXPECT_EQ(cone.base_radius, 0.2);
}

TEST(Resolution, OfWhatCannotMoveIsNone) {
    // A tumbler of water cannot grow because of its inner wall, and a sheet with two directions
    // cannot move.
    Scene scene = empty_scene();
    const std::uint32_t glass = add_material(scene, clear(1.5));
    scene.lathes.push_back(
        {{{0, 0}, {0.8, 0}, {0.8, 2}, {0.7, 2}, {0.7, 0.1}, {0, 0.1}}, Spline::linear, {}});
    add_object(scene, LatheRef{0}, glass);
    Mesh sheet;
    sheet.vertices = {{-1, 0, -1}, {1, 0, -1}, {0, 0, 1}, {-1, 2, -1}, {1, 2, -1}};
    sheet.faces = {{0, 1, 2}, {0, 1, 3}};
    scene.meshes.push_back(std::make_shared<Mesh>(sheet));
    add_object(scene, MeshRef{0, false});
    add_object(scene, Box{{-0.5, 0.5, -1}, {0.5, 0.9, -0.5}}, glass);
    add_object(scene, Cylinder{{0, 0.1, 0}, {0, 1, 0}, 0.7}, add_material(scene, clear(1.33)));
    // The sheet below, the water, the box at the sheet behind.
    EXPECT_THAT(resolutions(scene),
                testing::ElementsAre(Resolution::none, Resolution::overlapped, Resolution::sunk));
}

}  // namespace
}  // namespace lancer::reference
