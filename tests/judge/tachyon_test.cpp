// Tachyon's pictures, judged like those of any other renderer: what it does right agrees, and its
// differences are found.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "cli/scene_loader.h"
#include "judge/against/against.h"
#include "model/io/temporary_file.h"
#include "tests/reference/tachyon/tachyon.h"

namespace lancer::judge {
namespace {

using testing::Contains;
using testing::HasSubstr;

constexpr const char* stage = R"(
image { width 64 height 48 }
background [0.1, 0.2, 0.35]
camera main { position [0.5, 5, 6] look_at [0, 0.6, 0] fov 40 }
material floor { color [0.8, 0.7, 0.6] ambient 0.1 diffuse 0.6 }
material red { color [0.8, 0.3, 0.2] ambient 0.1 diffuse 0.6 }
material shiny { color [0.3, 0.6, 0.2] ambient 0.1 diffuse 0.5 phong 0.4 shininess 20 }
material mirror { color [0.2, 0.2, 0.3] ambient 0.1 diffuse 0.6 reflection 0.3 }
plane { normal [0, 1, 0] offset 0 material floor }
)";
constexpr const char* two_lamps = R"(
light point { position [-4, 6, 5] color [0.6, 0.6, 0.5] }
light point { position [4, 5, 6] color [0.5, 0.5, 0.5] }
)";

class Tachyon : public testing::Test {
  protected:
    void SetUp() override {
        program_ = find_tachyon();
        if (program_.empty()) GTEST_SKIP() << "NOT TESTED: there is no tachyon (Debian: tachyon)";
    }

    std::shared_ptr<const Scene> scene(const std::string& script) const {
        const std::string file = (folder_.path() / "scene.lancer").string();
        std::ofstream(file) << script;
        cli::Session session;
        auto scene = std::make_shared<Scene>(cli::SceneLoader(file, {}, session).load());
        prepare_for_validation(*scene);
        return scene;
    }

    /// Tachyon's picture of one scene, judged as one of another.
    Validation judged(const std::shared_ptr<const Scene>& ours, const Scene& theirs,
                      const Reading& reading, const std::string& format = "PPM48") const {
        EXPECT_EQ(tachyon_scene(theirs).not_said, 0U) << tachyon_scene(theirs).text;
        const auto picture = run_tachyon(program_, theirs, folder_.path(), format);
        EXPECT_TRUE(picture) << tachyon_scene(theirs).text;
        AgainstJob job;
        job.scene.name = "scene";
        job.scene.scene = ours;
        job.scene.view = {0, ours->width, ours->height};
        job.picture = picture.value_or("");
        job.reading = reading;
        return validate_against(job);
    }
    Validation judged(const std::string& script) const {
        const auto same = scene(script);
        return judged(same, *same, corner());
    }

    /// Linear light, rays through the pixels' upper right corners.
    static Reading corner() {
        Reading reading;
        reading.encoding.kind = Encoding::Kind::linear;
        reading.center_x = 1;
        reading.center_y = 0;
        return reading;
    }

    io::TemporaryFolder folder_;
    std::string program_;
};

std::string said(const Validation& v) {
    std::string text = "likely cause: " + v.cause.value_or("none") + "\n";
    for (const std::string& reason : v.reasons) text += reason + "\n";
    for (std::size_t i = 0; i < std::min<std::size_t>(5, v.judgement.different.size()); ++i) {
        const DifferentPixel& p = v.judgement.different[i];
        text += fmt::format("({}, {}) {}: {} {} {}, Tachyon {} {} {}\n", p.x, p.y,
                            class_name(p.pixel_class), p.ours.x, p.ours.y, p.ours.z, p.theirs.x,
                            p.theirs.y, p.theirs.z);
    }
    return text;
}

/// Balls, touching the floor and each other, one of them a mirror.
std::string balls() {
    return std::string(stage) + two_lamps + R"(
sphere { center [-1.3, 0.8, 0] radius 0.8 material red }
sphere { center [0.3, 0.8, 0] radius 0.8 material shiny }
sphere { center [1.4, 0.6, 0.9] radius 0.6 material mirror }
)";
}

/// A wavy sheet of triangles over the floor, with a normal at each corner, or flat.
std::string sheet(bool smooth, bool other_way_round = false) {
    constexpr int n = 8;
    std::string vertices;
    std::string normals;
    std::string faces;
    const auto comma = [](const std::string& list) { return list.empty() ? "" : ", "; };
    for (int j = 0; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) {
            const double x = 3.0 * i / n - 1.5;
            const double z = 3.0 * j / n - 1.5;
            vertices += fmt::format("{}[{}, {}, {}]", comma(vertices), x,
                                    0.8 + 0.2 * std::sin(3 * x + z), z);
            const double slope = 0.2 * std::cos(3 * x + z);
            normals += fmt::format("{}[{}, 1, {}]", comma(normals), -3 * slope, -slope);
        }
    }
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            const int a = j * (n + 1) + i;
            const int b = a + n + 1;
            for (std::array f : {std::array{a, b, a + 1}, std::array{a + 1, b, b + 1}}) {
                if (other_way_round) std::swap(f[1], f[2]);
                faces += fmt::format("{}[{}, {}, {}]", comma(faces), f[0], f[1], f[2]);
            }
        }
    }
    return fmt::format("mesh {{ vertices [{}] faces [{}] {} material shiny }}\n", vertices, faces,
                       smooth ? "normals [" + normals + "]" : "smooth false");
}

TEST_F(Tachyon, AgreesOnBallsLampsShadowsHighlightsAndMirrors) {
    const Validation v = judged(balls());
    EXPECT_EQ(v.verdict, Verdict::agrees) << said(v);
    EXPECT_LE(v.judgement.interior_max, 1e-5);
    EXPECT_FALSE(v.cause);
}

TEST_F(Tachyon, AgreesOnMeshes) {
    for (const bool smooth : {false, true}) {
        const Validation v = judged(std::string(stage) + two_lamps + sheet(smooth) +
                                    "sphere { center [0, 1.6, 0] radius 0.3 material red }");
        EXPECT_EQ(v.verdict, Verdict::agrees) << smooth << said(v);
        EXPECT_LE(v.judgement.interior_max, 1e-5) << smooth;
    }
}

TEST_F(Tachyon, AgreesOnSunsFadingLampsAndCylinders) {
    const Validation v = judged(std::string(stage) + R"(
light directional { direction [1, -2, -1] color [0.4, 0.4, 0.4] }
light point { position [-2, 3, 3] color [0.6, 0.6, 0.6] fade_distance 60 fade_power 2 }
light point { position [2, 3, 3] color [0.4, 0.4, 0.6] fade_distance 9 fade_power 1 }
cylinder { base [-0.5, 0.1, -0.5] top [0.6, 1, 0.5] radius 0.4 material shiny }
triangle { points [[-1.5, 0.2, 0], [-0.6, 0.3, 0.4], [-1, 1.6, -0.5]] material red }
)");
    EXPECT_EQ(v.verdict, Verdict::agrees) << said(v);
}

TEST_F(Tachyon, LooksThroughThePixelsCorners) {
    const auto same = scene(balls());
    Reading centre = corner();
    centre.center_x = centre.center_y = 0.5;
    const Validation v = judged(same, *same, centre);
    EXPECT_EQ(v.verdict, Verdict::differs);
    EXPECT_THAT(v.cause.value_or("none"), HasSubstr("(--pixel-center 1,0)")) << said(v);
}

TEST_F(Tachyon, RoundsDown) {
    const Validation v = judged(balls());
    EXPECT_THAT(v.reasons, Contains(HasSubstr("rounded down, not to the nearest")));
}

TEST_F(Tachyon, Has8BitsUnlessTold) {
    const auto same = scene(balls());
    const Validation v = judged(same, *same, corner(), "PPM");
    EXPECT_EQ(v.verdict, Verdict::failed);
    EXPECT_THAT(v.reasons, Contains(HasSubstr("has only 8 bits per channel, which is too coarse")));
}

TEST_F(Tachyon, TakesTheNormalsOfCornersWoundTheOtherWayForTheOtherSides) {
    const Validation v = judged(std::string(stage) + two_lamps + sheet(true, true));
    EXPECT_EQ(v.verdict, Verdict::differs);
    EXPECT_THAT(v.cause.value_or("none"), HasSubstr("the normals of object 2 are flipped"))
        << said(v);
}

/// A box from the front, without perspective: pixel (i, j) of 64 x 48 shows the point
/// (3 (i + 1 - 32) / 48, 1 - 3 (j - 24) / 48).
std::string box_from_the_front(double half_width) {
    return fmt::format(R"(
image {{ width 64 height 48 }}
background [0.1, 0.2, 0.35]
camera main {{ position [0, 1, 7] look_at [0, 1, 0] projection orthographic height 3 }}
material red {{ color [0.8, 0.3, 0.2] ambient 0.1 diffuse 0.6 }}
box {{ min [{}, 0.5, -0.5] max [{}, 1.5, 0.5] material red }}
)",
                       -half_width, half_width) +
           two_lamps;
}

TEST_F(Tachyon, AgreesOnCubesAndTakesTheWrongNormalsOfOtherBoxes) {
    const Validation cube = judged(box_from_the_front(0.5));
    EXPECT_EQ(cube.verdict, Verdict::agrees) << said(cube);
    // Its normal is along the axis in which a point is furthest from the box's centre.
    const Validation box = judged(box_from_the_front(1.3));
    EXPECT_EQ(box.verdict, Verdict::differs);
    EXPECT_THAT(box.reasons, Contains(HasSubstr("of them show object 1"))) << said(box);
    ASSERT_EQ(box.judgement.classes.size(), 64U * 48U);
    for (int j = 0; j < 48; ++j) {
        for (int i = 0; i < 64; ++i) {
            const double x = std::abs(3.0 * (i + 1 - 32) / 48);
            const double y = std::abs(3.0 * (j - 24) / 48);
            const bool at_an_edge =
                std::abs(x - 0.5) < 1e-6 || std::abs(x - 1.3) < 1e-6 || std::abs(y - 0.5) < 1e-6;
            if (at_an_edge) continue;
            const bool is_wrong = y < 0.5 && x > 0.5 && x < 1.3;
            EXPECT_EQ(box.judgement.classes[static_cast<std::size_t>(64 * j + i)],
                      is_wrong ? PixelClass::unexplained : PixelClass::agrees)
                << i << " " << j;
        }
    }
}

TEST_F(Tachyon, ShowsTheBackgroundWhereRaysAreFollowedNoFurther) {
    // Two mirrors that face each other. Where the depth is not sufficient, the missing light has
    // the weight 0.3 to the power of the depth, and Tachyon shows the background there.
    const std::string mirrors = std::string(stage) + two_lamps + R"(
sphere { center [-0.9, 0.9, 0] radius 0.8 material mirror }
sphere { center [0.9, 0.9, 0] radius 0.8 material mirror }
)";
    const Validation deep = judged(mirrors + "render { max_depth 8 }");
    EXPECT_EQ(deep.verdict, Verdict::agrees) << said(deep);
    const Validation flat = judged(mirrors + "render { max_depth 2 }");
    EXPECT_EQ(flat.verdict, Verdict::differs);
    EXPECT_GE(flat.judgement.different.size(), 10U);
    for (const DifferentPixel& pixel : flat.judgement.different) {
        EXPECT_NEAR(pixel.theirs.x - pixel.ours.x, 0.3 * 0.1, 2e-5);
        EXPECT_NEAR(pixel.theirs.y - pixel.ours.y, 0.3 * 0.2, 2e-5);
        EXPECT_NEAR(pixel.theirs.z - pixel.ours.z, 0.3 * 0.35, 2e-5);
    }
}

TEST_F(Tachyon, LeavesOutWhatALampBringsWhereItIsLittle) {
    // Less than 1/512, because of the cosine and the distance: a floor up to the horizon.
    std::string flat = stage;
    flat.replace(flat.find("0.5, 5, 6"), 9, "0.5, 2.4, 7");
    const Validation v = judged(flat +
                                "light point { position [-4, 6, 5] color [0.7, 0.7, 0.7] "
                                "fade_distance 6 fade_power 2 }\n"
                                "sphere { center [0, 1, 0] radius 0.8 material red }");
    EXPECT_EQ(v.verdict, Verdict::differs);
    EXPECT_GE(v.judgement.different.size(), 20U);
    for (const DifferentPixel& pixel : v.judgement.different) {
        // Only ambient light remains on the floor.
        EXPECT_NEAR(pixel.theirs.x, 0.08, 2e-5) << said(v);
        EXPECT_LT(pixel.ours.x - pixel.theirs.x, 0.8 / 512);
    }
}

TEST_F(Tachyon, ShadowsItsOwnBallsWhereTheSceneIsLarge) {
    // Tachyon keeps shadow rays off the surface where they begin by a constant distance.
    std::size_t unexplained = 2;
    for (const double size : {1.0, 1e5, 1e7}) {
        const auto at = [&](double x, double y, double z) {
            return fmt::format("[{}, {}, {}]", x * size, y * size, z * size);
        };
        const Validation v = judged(fmt::format(
            "image {{ width 64 height 48 }}\n"
            "camera main {{ position {} look_at {} fov 40 }}\n"
            "light point {{ position {} color [0.6, 0.6, 0.5] }}\n"
            "sphere {{ center {} radius {} material {{ color [0.8, 0.3, 0.2] ambient 0.1 diffuse "
            "0.6 }} }}",
            at(0.5, 2.4, 7), at(0, 0.6, 0), at(-4, 6, 5), at(0, 0.9, 0), 1.6 * size));
        const std::size_t found = v.judgement.count(PixelClass::unexplained);
        // At size 1, surfaces that are hardly lit may be black, see above.
        EXPECT_TRUE(size == 1 ? found <= 2 : found > 3 * unexplained) << size << said(v);
        unexplained = found;
        for (const DifferentPixel& pixel : v.judgement.different) {
            if (pixel.pixel_class != PixelClass::unexplained) continue;
            EXPECT_NEAR(pixel.theirs.x, 0.08, 2e-5) << "the ambient light alone";
        }
    }
}

}  // namespace
}  // namespace lancer::judge
