// union, intersection and difference: what the scene holds of them.
#include <gtest/gtest.h>

#include <array>

#include "tests/parser/script.h"

namespace lancer {
namespace {

using Kind = Composite::Kind;

const char* const nested = R"(
camera { position [0, 0, 5] look_at [0, 0, 0] }
light point { position [4, 4, 4] }
material steel { color [1, 0, 0] }
material brass { texture { checker [[1, 1, 1], [0, 0, 0]] } }
def hole(x) { cylinder { base [x, 0, 0] top [x, 1, 0] radius 0.1 } }
sphere { radius 1 }
group {
  difference {
    name "plate"
    group { box { min [0, 0, 0] max [1, 1, 1] } box { min [1, 0, 0] max [2, 1, 1] } translate [0, 1, 0] }
    for i in 0..2 { hole(i) }
    intersection { sphere { radius 1 material steel } sphere { radius 2 } translate [0, 2, 0] }
    shadow false
    material brass
  }
  translate [0, 0, 3]
}
sphere { radius 2 }
)";

TEST(Composites, AreOneObjectWithATreeOfLeavesInTheWorld) {
    const Scene scene = test::run(nested).scene;
    ASSERT_EQ(scene.objects.size(), 3U);
    ASSERT_EQ(scene.composites.size(), 1U);
    const Object& whole = scene.objects[1];
    EXPECT_EQ(std::get<CompositeRef>(whole.shape).composite, 0U);
    EXPECT_EQ(whole.transform, 0U);
    EXPECT_FALSE(whole.casts_shadow);
    EXPECT_EQ(scene.names[whole.name], "plate");

    const Composite& made = scene.composites[0];
    ASSERT_EQ(made.nodes.size(), 3U);
    EXPECT_EQ(made.nodes[0].kind, Kind::subtract);
    EXPECT_EQ(made.nodes[0].place.parent, none);
    EXPECT_EQ(made.nodes[0].end, 6U);
    EXPECT_EQ(made.nodes[1].kind, Kind::unite);
    EXPECT_TRUE(made.nodes[1].place.first);
    EXPECT_EQ(made.nodes[1].end, 2U);
    EXPECT_EQ(made.nodes[2].kind, Kind::intersect);
    EXPECT_FALSE(made.nodes[2].place.first);
    EXPECT_EQ(made.nodes[2].begin, 4U);

    ASSERT_EQ(made.leaves.size(), 6U);
    const std::array<std::uint32_t, 6> parents{1, 1, 0, 0, 2, 2};
    const std::array<bool, 6> first{true, false, false, false, true, false};
    const std::array<Vec3d, 6> shifts{Vec3d(0, 1, 3), Vec3d(0, 1, 3), Vec3d(0, 0, 3),
                                      Vec3d(0, 0, 3), Vec3d(0, 2, 3), Vec3d(0, 2, 3)};
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(made.leaves[i].place.parent, parents[i]) << i;
        EXPECT_EQ(made.leaves[i].place.first, first[i]) << i;
        EXPECT_EQ(scene.transforms[made.leaves[i].object.transform].shift, shifts[i]) << i;
    }
}

TEST(Composites, APartsOwnMaterialWinsAndTexturesLieInTheBlock) {
    const Scene scene = test::run(nested).scene;
    const Composite& made = scene.composites[0];
    const std::uint32_t brass = scene.objects[1].material;
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(made.leaves[i].object.material == brass, i != 4) << i;
        const Vec3d shift = scene.transforms[made.leaves[i].texture_space].shift;
        EXPECT_EQ(shift, i == 4 ? Vec3d(0, 2, 3) : Vec3d(0, 0, 3)) << i;
    }
}

TEST(Composites, StandAloneAndInGroups) {
    const Scene scene = test::run(R"(
camera { position [0, 0, 5] look_at [0, 0, 0] }
light point { position [4, 4, 4] }
union { sphere { radius 1 } }
group {
  sphere { radius 1 }
  union { sphere { radius 1 } sphere { radius 2 } }
  union { sphere { radius 3 } }
  sphere { radius 4 }
}
)")
                            .scene;
    ASSERT_EQ(scene.objects.size(), 5U);
    ASSERT_EQ(scene.composites.size(), 3U);
    EXPECT_EQ(scene.composites[1].leaves.size(), 2U);
    EXPECT_EQ(std::get<CompositeRef>(scene.objects[3].shape).composite, 2U);
    EXPECT_EQ(std::get<Sphere>(scene.objects[4].shape).radius, 4);
}

TEST(Composites, NestFiftyLevelsByHandAndByATemplateThatCallsItself) {
    const std::string stage =
        "camera { position [0, 0, 5] look_at [0, 0, 0] }\nlight point { position [4, 4, 4] }\n";
    std::string by_hand = stage;
    for (int level = 50; level > 0; --level)
        by_hand += "difference { sphere { radius " + std::to_string(level) + " } ";
    by_hand += "sphere { radius 0.5 }" + std::string(50, '}');
    const std::string called = stage + R"(
def onion(level) {
  difference {
    sphere { radius level }
    if level > 1 { onion(level - 1) } else { sphere { radius 0.5 } }
  }
}
onion(50)
)";
    for (const std::string& text : {by_hand, called}) {
        const Scene scene = test::run(text).scene;
        ASSERT_EQ(scene.composites.size(), 1U);
        const Composite& made = scene.composites[0];
        ASSERT_EQ(made.nodes.size(), 50U);
        ASSERT_EQ(made.leaves.size(), 51U);
        for (std::uint32_t i = 1; i < 50; ++i) {
            EXPECT_EQ(made.nodes[i].kind, Kind::subtract);
            EXPECT_EQ(made.nodes[i].place.parent, i - 1);
            EXPECT_FALSE(made.nodes[i].place.first);
            EXPECT_EQ(made.leaves[i].place.parent, i);
            EXPECT_EQ(std::get<Sphere>(made.leaves[i].object.shape).radius, 50.0 - i);
        }
    }
}

}  // namespace
}  // namespace lancer
