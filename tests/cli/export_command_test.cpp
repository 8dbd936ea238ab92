// `lancer export`, run as a user runs it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "model/io/png_file.h"
#include "reference/pov/signature.h"
#include "tests/cli/run_lancer.h"

namespace lancer::cli {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A scene with an image.
class Export : public testing::Test {
  protected:
    Export() {
        place_.write("a.lancer", small_scene());
        EXPECT_EQ(place_.run({"render", "a.lancer", "-o", "image.png", "--size", "4x4"}).code, 0);
        place_.write("a.lancer", small_scene() +
                                     "texture tiles { image \"image.png\" }\n"
                                     "sphere { radius 0.1 material { color tiles } }\n");
        fs::create_directory(place_.path("out"));
    }
    Finished export_to(const std::string& name, std::vector<std::string> more = {}) const {
        std::vector<std::string> arguments{"export", "a.lancer", "-o", name};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return place_.run(arguments);
    }
    std::vector<std::string> exported() const {
        std::vector<std::string> names;
        for (const auto& entry : fs::directory_iterator(place_.path("out")))
            names.push_back(entry.path().filename().string());
        std::sort(names.begin(), names.end());
        return names;
    }
    Workplace place_;
};

TEST_F(Export, WritesTheSceneAndItsImageAndTellsHowToRenderIt) {
    const Finished finished = export_to("out/a.pov");
    EXPECT_EQ(finished.code, 0) << finished.err;
    EXPECT_THAT(finished.out, HasSubstr("povray +Iout/a.pov +W64 +H48"));
    EXPECT_THAT(exported(), ElementsAre("a-0.png", "a.pov"));
    EXPECT_EQ(place_.image("out/a-0.png").data, place_.image("image.png").data);
    const Finished quiet = export_to("out/a.pov", {"-q"});
    EXPECT_EQ(quiet.code, 0);
    EXPECT_THAT(quiet.out, IsEmpty());
}

TEST_F(Export, ReplacesWhatItWroteItself) {
    ASSERT_EQ(export_to("out/a.pov").code, 0);
    const std::string before = place_.read("out/a.pov");
    ASSERT_EQ(export_to("out/a.pov", {"-D", "size=0.3"}).code, 0);
    EXPECT_NE(place_.read("out/a.pov"), before);
    // An image that changed replaces the one before.
    ASSERT_EQ(place_.run({"render", "a.lancer", "-o", "new.png", "--size", "4x4"}).code, 0);
    fs::rename(place_.path("new.png"), place_.path("image.png"));
    ASSERT_EQ(export_to("out/a.pov").code, 0);
    EXPECT_EQ(place_.image("out/a-0.png").data, place_.image("image.png").data);
}

TEST_F(Export, NeverReplacesWhatSomebodyElseWroteOrChanged) {
    ASSERT_EQ(export_to("out/a.pov").code, 0);
    const std::string own_text = place_.read("out/a.pov");
    const std::string own_image = place_.read("out/a-0.png");
    const auto refused = [&](const std::string& name, const std::string& bytes) {
        const std::string other = name == "out/a.pov" ? "out/a-0.png" : "out/a.pov";
        const std::string other_bytes = place_.read(other);
        place_.write(name, bytes);
        const Finished finished = export_to("out/a.pov", {"-D", "size=0.3"});
        EXPECT_EQ(finished.code, 2);
        EXPECT_THAT(finished.err, HasSubstr("'" + name + "' exists and is not as"));
        EXPECT_THAT(finished.err, HasSubstr("--force"));
        EXPECT_EQ(place_.read(name), bytes);
        EXPECT_EQ(place_.read(other), other_bytes) << "all or nothing";
    };
    refused("out/a.pov", "// by hand\n");
    refused("out/a.pov", "");
    std::string edited = own_text;
    edited.replace(edited.find("sphere"), 6, "Sphere");
    refused("out/a.pov", edited);
    place_.write("out/a.pov", own_text);
    refused("out/a-0.png", place_.read("image.png"));
    edited = own_image;
    edited[40] = static_cast<char>(edited[40] ^ 1);
    refused("out/a-0.png", edited);

    place_.write("out/a.pov", "// by hand\n");
    EXPECT_EQ(export_to("out/a.pov", {"--force"}).code, 0);
    EXPECT_EQ(place_.read("out/a.pov"), own_text);
    EXPECT_EQ(place_.read("out/a-0.png"), own_image);
}

TEST_F(Export, SparesTheImagesThatTheSceneShows) {
    // The name that the export gives its image is the scene's own image.
    fs::rename(place_.path("image.png"), place_.path("a-0.png"));
    place_.write("a.lancer", small_scene() +
                                 "texture tiles { image \"a-0.png\" }\n"
                                 "sphere { radius 0.1 material { color tiles } }\n");
    const std::string image = place_.read("a-0.png");
    for (const char* how : {"-q", "--force"}) {
        const Finished finished = export_to("a.pov", {how});
        EXPECT_EQ(finished.code, 2);
        EXPECT_THAT(finished.err, HasSubstr("'a-0.png' would overwrite 'a-0.png'"));
    }
    EXPECT_EQ(place_.read("a-0.png"), image);
    EXPECT_FALSE(place_.exists("a.pov"));
}

TEST(Signature, HoldsForTheBytesItWasMadeFor) {
    const std::string text = reference::with_signature("sphere { 0, 1 }\n");
    EXPECT_TRUE(reference::is_signed(text));
    EXPECT_TRUE(text.starts_with("sphere { 0, 1 }\n// lancer export "));
    EXPECT_FALSE(reference::is_signed("S" + text.substr(1)));
    EXPECT_FALSE(reference::is_signed(text + "\n"));
    EXPECT_FALSE(reference::is_signed("sphere { 0, 1 }\n"));
    EXPECT_FALSE(reference::is_signed(""));

    const std::string png = io::encode_png(Image(3, 2, 3), {}, "a");
    const std::string own = reference::with_signature(png);
    EXPECT_TRUE(reference::is_signed(own));
    EXPECT_FALSE(reference::is_signed(png));
    EXPECT_EQ(io::decode_png(own, "a", io::ColorSpace::automatic).data,
              io::decode_png(png, "a", io::ColorSpace::automatic).data);
}

}  // namespace
}  // namespace lancer::cli
