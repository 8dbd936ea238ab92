// `lancer probe`, run as a user runs it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/cli/run_lancer.h"

namespace lancer::cli {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

/// A red pane before a white wall, an opaque ball before one of two lights, a bored block beside.
const char* const pane_scene = R"(image { width 40 height 30 }
render { max_depth 3 min_contribution 0.01 }
background [0, 0, 0.5]
camera main { position [0, 0, 5] look_at [0, 0, 0] fov 40 }
light point { position [0, 0, 4] color [1, 1, 1] }
light point { position [0, 9, 0.5] color [1, 1, 1] }
material wall { color [1, 1, 1] ambient 0.25 diffuse 0.5 }
material pane { color [1, 0.5, 0.25] ambient 0 diffuse 0 filter 0.8 reflection 0.005 }
plane { name "wall" normal [0, 0, 1] material wall }
box { min [-0.4, -0.4, 1] max [0.4, 0.4, 1.1] material pane }
sphere { name "lid" center [0, 5, 0.4] radius 0.5 material wall }
difference {
  box { min [0.6, -0.4, 0] max [1.4, 0.4, 1] material wall }
  cylinder { name "bore" base [1, 0, 0.5] top [1, 0, 2] radius 0.2 material wall }
}
)";

class Probe : public testing::Test {
  protected:
    Probe() { place.write("pane.lancer", pane_scene); }

    Finished probe(std::vector<std::string> more) const {
        std::vector<std::string> arguments{"probe", "pane.lancer"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return place.run(arguments);
    }
    json as_json(std::vector<std::string> more) const {
        more.insert(more.end(), {"--json", "-"});
        const Finished finished = probe(more);
        EXPECT_EQ(finished.code, 0) << finished.err;
        return json::parse(finished.out);
    }

    Workplace place;
};

TEST_F(Probe, TellsWhatTheRayMeetsAndWhatEachLightLoses) {
    const Finished finished = probe({"20,15"});
    EXPECT_EQ(finished.code, 0) << finished.err;
    EXPECT_EQ(finished.err, "");
    const std::string& text = finished.out;
    EXPECT_THAT(text, HasSubstr("pixel 20,15 of 40x30, camera main: ["));
    EXPECT_THAT(text, HasSubstr("it hits the outside of box (pane.lancer:10:1)"));
    EXPECT_THAT(text, HasSubstr("behind it, inside of box (pane.lancer:10:1)"));
    EXPECT_THAT(text, HasSubstr("it hits the outside of plane \"wall\" (pane.lancer:9:1)"));
    EXPECT_THAT(text,
                HasSubstr("material pane: color [1, 0.5, 0.25], lets through [0.8, 0.4, 0.2]"));
    // Out of the pane and into it: twice what it lets pass.
    EXPECT_THAT(text, HasSubstr("box (pane.lancer:10:1) lets through [0.8, 0.4, 0.2]"));
    EXPECT_THAT(text, HasSubstr(", [0.64, 0.16, 0.04] arrives and adds ["));
    EXPECT_THAT(text, HasSubstr("blocked by sphere \"lid\" (pane.lancer:11:1)"));
    EXPECT_THAT(text, HasSubstr("not followed: its weight 0.005 is below min_contribution 0.01"));
    EXPECT_THAT(text, HasSubstr("ends: this surface lets nothing through"));
}

TEST_F(Probe, NamesThePartOfAComposite) {
    const json found = as_json({"30,15"});
    const json& of = found["rays"][0]["contacts"][0]["surfaces"][0]["of"];
    EXPECT_EQ(of["leaf"]["name"], "cylinder \"bore\"");
    EXPECT_EQ(of["leaf"]["place"], "pane.lancer:14:3");
    EXPECT_EQ(of["place"], "pane.lancer:12:1");
    EXPECT_THAT(probe({"30,15"}).out, HasSubstr("cylinder \"bore\" (pane.lancer:14:3)"));
}

TEST_F(Probe, NamesEachKindOfTexture) {
    place.write("painted.ppm", "P3 1 1 255 255 0 0");
    const std::string before = R"(image { width 3 height 3 }
camera main { position [0, 0, 5] look_at [0, 0, 0] fov 20 }
material m { color )";
    const std::string after = R"( }
mesh { vertices [[-9, -9, 0], [9, -9, 0], [0, 9, 0]] faces [[0, 1, 2]]
       colors [[1, 0, 0], [0, 1, 0], [0, 0, 1]] material m })";
    const std::vector<std::array<std::string, 3>> kinds{
        {"vertex", "vertex", " of its vertices"},
        {"texture { checker [[1, 1, 1], [0, 0, 0]] }", "checker", " of its checker"},
        {"texture { gradient [1, 0, 0] stops [[0, [0, 0, 0]], [1, [1, 1, 1]]] }", "gradient",
         " of its gradient"},
        {R"(texture { image "painted.ppm" })", "image", R"( of its image "painted.ppm")"}};
    for (const auto& [color, kind, words] : kinds) {
        place.write("kinds.lancer", before + color + after);
        const Finished text = place.run({"probe", "kinds.lancer", "1,1"});
        EXPECT_EQ(text.code, 0) << text.err;
        EXPECT_THAT(text.out, HasSubstr(words));
        const json found =
            json::parse(place.run({"probe", "kinds.lancer", "1,1", "--json", "-"}).out);
        EXPECT_EQ(found["rays"][0]["contacts"][0]["surfaces"][0]["texture"]["kind"], kind);
    }
}

TEST_F(Probe, WritesJsonWithTheColoursOfThePicture) {
    const json found = as_json({"12,7", "--size", "20x20"});
    ASSERT_EQ(place.run({"render", "pane.lancer", "--size", "20x20", "-o", "p.exr"}).code, 0);
    const Image image = place.image("p.exr");
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_EQ(static_cast<float>(found["pixel"]["color"][c].get<double>()),
                  static_cast<float>(image.pixel(12, 7)[c]));
    EXPECT_EQ(found["pixel"]["color"], found["sample"]["color"]);
}

TEST_F(Probe, TellsWhichRayOfSeveralItShows) {
    const Finished middle = probe({"20,15", "--samples", "3"});
    EXPECT_THAT(middle.out, HasSubstr("ray 5 of the 9 whose mean it is"));
    EXPECT_THAT(middle.out, HasSubstr("through 20.5,15.5 of the picture"));
    const Finished first = probe({"20,15", "--samples", "3", "--sample", "1"});
    EXPECT_THAT(first.out, HasSubstr("ray 1 of the 9"));
    const Finished beyond = probe({"20,15", "--samples", "3", "--sample", "10"});
    EXPECT_EQ(beyond.code, 2);
    EXPECT_THAT(beyond.err, HasSubstr("--sample 10: the pixel has 9 rays"));
    EXPECT_THAT(probe({"20,15"}).out, Not(HasSubstr("whose mean")));
}

TEST_F(Probe, RefusesPixelsThatAreNotThere) {
    const Finished outside = probe({"40,0"});
    EXPECT_EQ(outside.code, 2);
    EXPECT_THAT(outside.err, HasSubstr("pixel 40,0 is outside of the picture of 40x30: the last is "
                                       "39,29"));
    for (const char* wrong : {"20", "20,", "20,x", "20;15", "1,2,3", "99999999999,1"}) {
        const Finished finished = probe({wrong});
        EXPECT_EQ(finished.code, 2) << wrong;
        EXPECT_THAT(finished.err, HasSubstr("is not a pixel: expected X,Y")) << wrong;
    }
    EXPECT_EQ(probe({}).code, 2);
}

}  // namespace
}  // namespace lancer::cli
