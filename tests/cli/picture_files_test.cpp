// Unusual and damaged picture files: exit codes and messages.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "model/io/image_file.h"
#include "tests/cli/run_lancer.h"
#include "tests/io/tiff_file.h"

namespace lancer::cli {
namespace {

using testing::HasSubstr;

/// A picture on a wall that fills the camera's view, pixel by pixel.
std::string wall(const std::string& picture, int width, int height) {
    return "image { width " + std::to_string(width) + " height " + std::to_string(height) +
           " }\n"
           "camera { position [0.5, 0.5, 1] look_at [0.5, 0.5, 0] projection orthographic height 1 "
           "}\n"
           "light point { position [0, 0, 9] }\n"
           "texture wall { image \"" +
           picture +
           "\" filter nearest color_space linear }\n"
           "plane { normal [0, 0, 1] material { ambient 0 diffuse 0 emission 1 color wall } }\n";
}

io::TiffFile planes() {
    io::TiffFile file;
    file.width = 17;
    file.height = 17;
    file.separate = true;
    file.pack_bits = true;
    file.value = [](auto x, auto y, auto c) { return (30 + 60 * c + 15 * y + 3 * x) & 255; };
    return file;
}

TEST(PictureFiles, InPlanesAndOfInksAreShown) {
    const Workplace place;
    place.write("planes.tif", planes().bytes());
    place.write("planes.lancer", wall("planes.tif", 17, 17));
    ASSERT_EQ(place.run({"render", "planes.lancer", "-o", "planes.exr"}).code, 0);
    const Image shown = place.image("planes.exr");
    EXPECT_NEAR(shown.pixel(3, 2)[1], (30 + 60 + 30 + 9) / 255.0, 1e-6);
    EXPECT_NEAR(shown.pixel(16, 16)[2], ((30 + 120 + 240 + 48) & 255) / 255.0, 1e-6);

    io::TiffFile inks;
    inks.width = inks.height = 20;
    inks.samples = 4;
    inks.photometric = 5;
    inks.tile = 16;
    inks.value = [](auto, auto, auto ink) { return ink == 0 ? 200 : ink == 3 ? 30 : 60; };
    place.write("inks.tif", inks.bytes());
    place.write("inks.lancer", wall("inks.tif", 20, 20));
    ASSERT_EQ(place.run({"render", "inks.lancer", "-o", "inks.exr"}).code, 0);
    EXPECT_NEAR(place.image("inks.exr").pixel(19, 19)[0], 49 / 255.0, 1e-6);
}

TEST(PictureFiles, ThatAreDamagedAreErrorsAtTheTexturesName) {
    const Workplace place;
    const std::string whole = planes().bytes();
    place.write("whole.tif", whole);
    place.write("cut.tif", whole.substr(0, whole.size() - 40));
    place.write("scene.lancer", wall("cut.tif", 17, 17));
    for (const char* command : {"check", "info", "render"}) {
        const Finished finished = place.run({command, "scene.lancer"});
        EXPECT_EQ(finished.code, 3);
        EXPECT_THAT(finished.err, HasSubstr("scene.lancer:4:"));
        EXPECT_THAT(finished.err, HasSubstr("the file is truncated"));
    }
    const Finished compared = place.run({"compare", "whole.tif", "cut.tif"});
    EXPECT_EQ(compared.code, 4);
    EXPECT_THAT(compared.err, HasSubstr("cut.tif"));
}

TEST(PictureFiles, ThatCostTooMuchAreErrorsThatNameTheLimit) {
    const Workplace place;
    io::write_image(place.path("large.exr"), Image(1000, 1000), {});
    place.write("scene.lancer", wall("large.exr", 4, 4));
    const Finished checked = place.run({"check", "scene.lancer", "--limit-picture-memory", "8"});
    EXPECT_EQ(checked.code, 3);
    EXPECT_THAT(checked.err, HasSubstr("allowed 8 MiB (--limit-picture-memory)"));
    EXPECT_EQ(place.run({"check", "scene.lancer"}).code, 0);
    const Finished compared =
        place.run({"compare", "large.exr", "large.exr", "--limit-picture-memory", "8"});
    EXPECT_EQ(compared.code, 4);
    EXPECT_EQ(place.run({"compare", "large.exr", "large.exr"}).code, 0);
    for (const char* wrong : {"0", "-1", "x", "99999999999"}) {
        EXPECT_EQ(place.run({"check", "scene.lancer", "--limit-picture-memory", wrong}).code, 2);
        EXPECT_EQ(place.run({"check", "scene.lancer", "--limit-picture-seconds", wrong}).code, 2);
    }
}

TEST(PictureFiles, WithAValueThatIsNoNumberSayWhere) {
    const Workplace place;
    for (const double value :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        Image image(5, 4);
        image.pixel(3, 1)[1] = value;
        io::write_image(place.path("sky.exr"), image, {});
        place.write("scene.lancer", wall("sky.exr", 4, 4));
        const Finished finished = place.run({"check", "scene.lancer"});
        EXPECT_EQ(finished.code, 3);
        EXPECT_THAT(finished.err, HasSubstr("scene.lancer:4:"));
        EXPECT_THAT(finished.err, HasSubstr("sky.exr': green at (3, 1) is "));
        EXPECT_EQ(place.run({"compare", "sky.exr", "sky.exr"}).code, 1);
    }
}

TEST(PictureFiles, NeedNobodyToServeThem) {
    const Workplace place;
    EXPECT_EQ(place.run({"serve-pictures"}).code, 2);
}

}  // namespace
}  // namespace lancer::cli
