// The exporter compared with scenes written by hand in both languages, without the tracer.
#include <fstream>
#include <iterator>

#include "model/io/png_file.h"
#include "tests/reference/pov/pair_scenes.h"
#include "tests/reference/pov/povray_fixture.h"

namespace lancer::reference {
namespace {

std::string pair_file(const std::string& name) {
    std::ifstream file(LANCER_SOURCE_DIR "/tests/pairs/" + name, std::ios::binary);
    EXPECT_TRUE(file) << name;
    return {std::istreambuf_iterator<char>(file), {}};
}

class Pairs : public WithPovRay {
  protected:
    /// What POV-Ray makes of the hand-written scene and of the exported one, at the size of the
    /// stored picture, in steps of 1/65535.
    void expect_same(const std::string& name, const Scene& scene) const {
        const ExportView view{0, 160, 120};
        const Image by_hand = rendered(
            pair_file(name + ".pov"),
            {{"common.inc", pair_file("common.inc")}, {"motif.png", pair_file("motif.png")}}, view);
        const Image exported = rendered(scene, view);
        const Difference found = difference(by_hand, exported, 1.5 / 65535);
        EXPECT_EQ(found.share_over, 0) << name << ": largest " << found.largest;
    }
};

TEST_F(Pairs, TheExportOfSolidsIsThePictureOfTheHandWrittenScene) {
    expect_same("solids", solids_scene());
}

TEST_F(Pairs, TheExportOfNestedGlassIsThePictureOfTheHandWrittenScene) {
    expect_same("glass_nested", glass_nested_scene());
}

TEST_F(Pairs, TheExportOfPlanarTexturesIsThePictureOfTheHandWrittenScene) {
    expect_same("tex_planar", tex_planar_scene());
}

TEST_F(Pairs, ThisPovRayMakesTheStoredPictures) {
    for (const std::string name : {"solids", "glass_nested", "tex_planar"}) {
        const Image stored = io::decode_png(pair_file(name + ".png"), name, io::ColorSpace::linear);
        const Image now = rendered(
            pair_file(name + ".pov"),
            {{"common.inc", pair_file("common.inc")}, {"motif.png", pair_file("motif.png")}},
            {0, 160, 120});
        EXPECT_LE(difference(stored, now, 0).largest, 1.5 / 65535) << name;
    }
}

}  // namespace
}  // namespace lancer::reference
