// `lancer render`, run as a user runs it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/run_lancer.h"
#include "tracer/wide/level.h"

namespace lancer::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class Render : public testing::Test {
  protected:
    Render() { place_.write("a.lancer", small_scene()); }
    Finished render(std::vector<std::string> options) const {
        options.insert(options.begin(), {"render", "a.lancer"});
        return place_.run(options);
    }
    Workplace place_;
};

TEST_F(Render, WritesThePictureBesideWithTheScenesNameAndSaysSo) {
    const Finished finished = render({});
    EXPECT_EQ(finished.code, 0) << finished.err;
    EXPECT_THAT(finished.out, HasSubstr("a.png"));
    EXPECT_THAT(place_.files(), ElementsAre("a.lancer", "a.png"));
    const Image image = place_.image("a.png");
    EXPECT_EQ(image.width, 64);
    EXPECT_EQ(image.height, 48);
}

TEST_F(Render, NothingIsDrawnWhenNobodyLooks) {
    const Finished finished = render({"--samples", "8"});
    EXPECT_THAT(finished.err, IsEmpty());
    EXPECT_THAT(finished.out, Not(HasSubstr("\033")));
    const Finished quiet = render({"-q"});
    EXPECT_THAT(quiet.out + quiet.err, IsEmpty());
}

TEST_F(Render, MessagesHaveNoEscapeSequencesInAFile) {
    place_.write("a.lancer", "sphere { raduis 1 }");
    const Finished finished = render({});
    EXPECT_EQ(finished.code, 3);
    EXPECT_THAT(finished.err, HasSubstr("a.lancer:1:10: error: "));
    EXPECT_THAT(finished.err, Not(HasSubstr("\033")));
    EXPECT_THAT(place_.files(), ElementsAre("a.lancer"));
}

TEST_F(Render, ACropIsThatPartOfTheWholePicture) {
    ASSERT_EQ(render({"-o", "whole.exr"}).code, 0);
    ASSERT_EQ(render({"-o", "part.exr", "--crop", "10,20,30,15"}).code, 0);
    const Image whole = place_.image("whole.exr");
    const Image part = place_.image("part.exr");
    ASSERT_EQ(part.width, 30);
    ASSERT_EQ(part.height, 15);
    for (int y = 0; y < part.height; ++y) {
        for (int x = 0; x < part.width; ++x) {
            for (int c = 0; c < 3; ++c)
                ASSERT_EQ(part.pixel(x, y)[c], whole.pixel(x + 10, y + 20)[c]) << x << " " << y;
        }
    }
}

TEST_F(Render, ACropOutsideThePictureIsWrongUse) {
    for (const char* crop : {"64,0,1,1", "0,48,1,1", "60,0,5,1", "0,0,65,1", "0,0,1,2147483647"}) {
        const Finished finished = render({"--crop", crop});
        EXPECT_EQ(finished.code, 2) << crop;
        EXPECT_THAT(finished.err, HasSubstr("64x48"));
    }
    EXPECT_EQ(render({"--crop", "63,47,1,1"}).code, 0);
}

TEST_F(Render, FramesBecomePicturesAndTheFrameMovesTheBall) {
    const Finished finished = render({"--frames", "8..10", "-o", "ball-%03d.png"});
    EXPECT_EQ(finished.code, 0) << finished.err;
    EXPECT_THAT(place_.files(),
                ElementsAre("a.lancer", "ball-008.png", "ball-009.png", "ball-010.png"));
    EXPECT_NE(place_.read("ball-008.png"), place_.read("ball-010.png"));
}

TEST_F(Render, TimeRunsFromZeroToOneOverTheFrames) {
    place_.write("a.lancer", small_scene() + "print frame, time\n");
    EXPECT_EQ(render({"--frames", "2..4"}).err, "2 0\n3 0.5\n4 1\n");
    EXPECT_EQ(render({"--frames", "2..5", "--loop"}).err, "2 0\n3 0.25\n4 0.5\n5 0.75\n");
    EXPECT_EQ(render({}).err, "0 0\n");
}

TEST_F(Render, AnErrorInALaterFrameKeepsTheEarlierPictures) {
    place_.write("a.lancer", small_scene() + "assert frame < 3, \"too far\"\n");
    const Finished finished = render({"--frames", "1..5", "-o", "f%d.png"});
    EXPECT_EQ(finished.code, 3);
    EXPECT_THAT(finished.err, HasSubstr("too far"));
    EXPECT_THAT(place_.files(), ElementsAre("a.lancer", "f1.png", "f2.png"));
}

TEST_F(Render, TheCommandLineDefinesParams) {
    ASSERT_EQ(render({"-o", "small.png", "-D", "size=0.1+0.1"}).code, 0);
    ASSERT_EQ(render({"-o", "large.png"}).code, 0);
    EXPECT_NE(place_.read("small.png"), place_.read("large.png"));
    const Finished unknown = render({"-D", "sise=1"});
    EXPECT_EQ(unknown.code, 2);
    EXPECT_THAT(unknown.err, HasSubstr("'size'"));
    EXPECT_EQ(render({"-D", "size=1/0"}).code, 2);
    const Finished block = render({"-D", "size=material { color 1 }"});
    EXPECT_EQ(block.code, 2);
    EXPECT_THAT(block.err, HasSubstr("a material or texture cannot be given here"));
    EXPECT_EQ(render({"-D", "size=0.1", "-D", "b=[texture { checker [1, 1, 1] [0, 0, 0] }]"}).code,
              2);
    EXPECT_EQ(render({"-D", "size"}).code, 2);
    EXPECT_EQ(render({"-D", "size="}).code, 2);
    EXPECT_EQ(render({"-D", " size = 0.2 "}).code, 0);
    EXPECT_THAT(render({"-D", "size=sise"}).err, HasSubstr("-D size: 'sise' is not defined"));
}

TEST_F(Render, NoOutputIsWrittenOverWhatIsReadOrOverAnother) {
    const std::string scene = place_.read("a.lancer");
    EXPECT_EQ(render({"--stats", "a.lancer"}).code, 2);
    EXPECT_EQ(render({"--stats", "./a.lancer"}).code, 2);
    EXPECT_EQ(render({"-o", "b.png", "--stats", "b.png"}).code, 2);
    EXPECT_THAT(place_.files(), ElementsAre("a.lancer"));
    EXPECT_EQ(place_.read("a.lancer"), scene);

    ASSERT_EQ(render({}).code, 0);
    const std::string picture = place_.read("a.png");
    place_.write("a.lancer", scene + "texture t { image \"a.png\" }\n");
    const Finished finished = render({});  // to a.png, by default
    EXPECT_EQ(finished.code, 2);
    EXPECT_THAT(finished.err, HasSubstr("'a.png' would overwrite 'a.png'"));
    EXPECT_EQ(place_.read("a.png"), picture);
}

TEST_F(Render, ADeviceNeedsNoEndingAndGetsAPng) {
    EXPECT_THAT(render({"-o", "/dev/stdout"}).out,
                AllOf(testing::StartsWith("\x89PNG"), testing::EndsWith("IEND\xAE\x42\x60\x82")));
    EXPECT_EQ(render({"-o", "/dev/null"}).code, 0);
    EXPECT_EQ(render({"-o", "/dev/full"}).code, 4);
    EXPECT_EQ(render({"-o", "."}).code, 4);
    EXPECT_EQ(render({"-o", ""}).code, 2);
    EXPECT_EQ(render({"-o", "picture"}).code, 2);
}

TEST_F(Render, StatisticsHaveTheirKeys) {
    const Finished finished = render({"--stats", "s.json", "--threads", "2"});
    ASSERT_EQ(finished.code, 0) << finished.err;
    const nlohmann::json json = nlohmann::json::parse(place_.read("s.json"));
    for (const char* key : {"parse", "evaluate", "build", "trace", "write", "total"})
        EXPECT_GE(json.at("seconds").at(key).get<double>(), 0) << key;
    EXPECT_EQ(json.at("rays").at("primary"), 64 * 48);
    EXPECT_GT(json.at("rays").at("shadow"), 0);
    EXPECT_GT(json.at("rays").at("reflected"), 0);
    EXPECT_EQ(json.at("rays").at("transmitted"), 0);
    EXPECT_GT(json.at("rays_per_second"), 0);
    EXPECT_EQ(json.at("threads"), 2);
    EXPECT_EQ(json.at("level"), name_of(best_level()));
    ASSERT_EQ(render({"--stats", "s.json", "--level", "scalar"}).code, 0);
    EXPECT_EQ(nlohmann::json::parse(place_.read("s.json")).at("level"), "scalar");
    EXPECT_GT(json.at("peak_memory_bytes"), 1'000'000);
    EXPECT_EQ(json.at("media_lost"), 0);
    EXPECT_EQ(json.at("counts").at("shapes"), 3);
    EXPECT_EQ(json.at("counts").at("triangles"), 0);
    EXPECT_EQ(json.at("counts").at("lights"), 1);
}

TEST_F(Render, SecondsOfThePhasesAddUpToNoMoreThanTheWhole) {
    ASSERT_EQ(render({"--stats", "s.json", "--frames", "1..3"}).code, 0);
    const auto seconds = nlohmann::json::parse(place_.read("s.json")).at("seconds");
    double sum = 0;
    for (const char* key : {"parse", "evaluate", "build", "trace", "write"})
        sum += seconds.at(key).get<double>();
    EXPECT_LE(sum, seconds.at("total").get<double>());
}

TEST_F(Render, TheSceneMayComeFromStandardInput) {
    const Finished finished = place_.run({"render", "-", "-o", "in.png"}, small_scene());
    EXPECT_EQ(finished.code, 0) << finished.err;
    ASSERT_EQ(render({"-o", "file.png"}).code, 0);
    EXPECT_EQ(place_.read("in.png"), place_.read("file.png"));
}

TEST_F(Render, ACameraIsPickedByItsName) {
    ASSERT_EQ(render({"-o", "first.png"}).code, 0);
    ASSERT_EQ(render({"-o", "front.png", "--camera", "front"}).code, 0);
    ASSERT_EQ(render({"-o", "above.png", "--camera", "above"}).code, 0);
    EXPECT_EQ(place_.read("first.png"), place_.read("front.png"));
    EXPECT_NE(place_.read("first.png"), place_.read("above.png"));
    const Finished wrong = render({"--camera", "below"});
    EXPECT_EQ(wrong.code, 2);
    EXPECT_THAT(wrong.err, HasSubstr("front, above"));
}

TEST_F(Render, NoCameraIsAnErrorOfTheScene) {
    place_.write("a.lancer", "sphere { radius 1 }\nlight point { position [1, 2, 3] }\n");
    const Finished finished = render({});
    EXPECT_EQ(finished.code, 3);
    EXPECT_THAT(finished.err, HasSubstr("error: the scene has no camera"));
    EXPECT_FALSE(place_.exists("a.png"));
}

TEST_F(Render, TheCommandLineWinsOverTheRenderBlock) {
    place_.write("a.lancer", small_scene() + "render { max_depth 5 samples 1 shadows true }\n");
    const auto rays = [this](std::vector<std::string> options) {
        options.insert(options.end(), {"--stats", "s.json"});
        EXPECT_EQ(render(options).code, 0);
        return nlohmann::json::parse(place_.read("s.json")).at("rays");
    };
    EXPECT_EQ(rays({"--samples", "3"}).at("primary"), 9 * 64 * 48);
    EXPECT_EQ(rays({"--size", "10x7"}).at("primary"), 70);
    EXPECT_EQ(rays({"--max-depth", "1"}).at("reflected"), 0);
    EXPECT_EQ(rays({"--no-shadows"}).at("shadow"), 0);
}

TEST_F(Render, APreviewIsAQuarterOfTheSizeWithOneRayPerPixel) {
    place_.write("a.lancer", small_scene() + "render { samples 3 }\n");
    const auto rays = [this](std::vector<std::string> options) {
        options.insert(options.end(), {"--preview", "--stats", "s.json"});
        const Finished finished = render(options);
        EXPECT_EQ(finished.code, 0) << finished.err;
        return nlohmann::json::parse(place_.read("s.json")).at("rays").at("primary").get<int>();
    };
    EXPECT_EQ(rays({}), 16 * 12);
    EXPECT_FALSE(place_.exists("a.png")) << "the picture itself is not replaced";
    EXPECT_EQ(place_.image("a-preview.png").width, 16);
    EXPECT_EQ(rays({"--samples", "2"}), 4 * 16 * 12) << "what is asked for wins";
    EXPECT_EQ(rays({"--size", "81x1"}), 21);
    EXPECT_EQ(rays({"--crop", "3,4,6,4"}), 3) << "the pixels 0 to 2 of one row";
    EXPECT_EQ(render({"--preview", "--crop", "64,0,1,1"}).code, 2);
}

TEST_F(Render, APictureThatDoesNotFitIsRefused) {
    EXPECT_EQ(render({"--size", "1000000x1000000"}).code, 2);
    const Finished finished = render({"--size", "65535x65535"});
    EXPECT_EQ(finished.code, 2);
    EXPECT_THAT(finished.err, HasSubstr("memory"));
    EXPECT_EQ(render({"--size", "65535x65535", "--crop", "50000,50000,4,3"}).code, 0)
        << "a small part of it does fit";
}

TEST_F(Render, WhatCannotBeWrittenIsKnownBeforeTheWork) {
    for (const char* output : {"nowhere/a.png", "/proc/a.png", "folder.png"}) {
        place_.run({"check", "a.lancer"});
        if (std::string(output) == "folder.png") {
            std::filesystem::create_directory(place_.path("folder.png"));
        }
        place_.write("a.lancer", small_scene() + "print \"evaluated\"\n");
        const Finished finished = render({"-o", output});
        EXPECT_EQ(finished.code, 4) << output;
        EXPECT_THAT(finished.err, HasSubstr(output));
        EXPECT_THAT(finished.err, Not(HasSubstr("evaluated")));
    }
}

TEST_F(Render, TheKindOfPictureFollowsTheEnding) {
    const Finished unknown = render({"-o", "a.gif"});
    EXPECT_EQ(unknown.code, 2);
    EXPECT_THAT(unknown.err, HasSubstr(".png .exr"));
    EXPECT_EQ(render({"-o", "a"}).code, 2);
    EXPECT_EQ(render({"-o", "a.jpg", "--bits", "16"}).code, 2);
    EXPECT_EQ(render({"-o", "a.png", "--bits", "12"}).code, 2);
    EXPECT_EQ(render({"-o", "a.png", "--aov"}).code, 2);
    EXPECT_EQ(render({"-o", "a.exr", "--aov"}).code, 0);
    EXPECT_EQ(render({"-o", "a.jpg", "--alpha"}).code, 2);
    EXPECT_EQ(render({"-o", "a.png", "--alpha", "--max-error", "0.1"}).code, 2);
    EXPECT_EQ(render({"-o", "a.exr", "--aov", "--alpha"}).code, 0);
    EXPECT_EQ(render({"-o", "a.PPM", "--bits", "16", "--linear"}).code, 0);
    EXPECT_THAT(place_.files(), ElementsAre("a.PPM", "a.exr", "a.lancer"));
}

TEST_F(Render, WrongUseIsToldApart) {
    for (const std::vector<std::string>& options :
         std::vector<std::vector<std::string>>{{"--bogus"},
                                               {"--size", "3"},
                                               {"--frames", "3..1"},
                                               {"--loop"},
                                               {"--samples", "0"},
                                               {"--threads", "-1"},
                                               {"--max-depth", "1e3"},
                                               {"--min-contribution", "nan"},
                                               {"--tolerance", "0"},
                                               {"--precision", "half"},
                                               {"--level", "mmx"},
                                               {"--max-error", "2"},
                                               {"--time", "0"},
                                               {"--passes", "0"},
                                               {"--time", "1", "--passes", "2"},
                                               {"--time", "1", "--samples", "2"},
                                               {"--limit-calls", "0"},
                                               {"-o"},
                                               {"b.lancer"}}) {
        const Finished finished = render(options);
        EXPECT_EQ(finished.code, 2) << options.front();
        EXPECT_THAT(finished.err, HasSubstr("lancer: error: ")) << options.front();
    }
    EXPECT_THAT(place_.files(), ElementsAre("a.lancer"));
}

}  // namespace
}  // namespace lancer::cli
