// What holds for all commands, and `check`, `info` and `compare`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/cli/run_lancer.h"
#include "tracer/wide/level.h"

namespace lancer::cli {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

const std::vector<std::string> commands{"render", "check", "info", "compare", "stability"};

TEST(Commands, HelpAndVersionAreEverywhere) {
    const Workplace place;
    EXPECT_EQ(place.run({"--help"}).code, 0);
    EXPECT_THAT(place.run({"--version"}).out, StartsWith("lancer "));
    for (const std::string& command : commands) {
        const Finished help = place.run({command, "--help"});
        EXPECT_EQ(help.code, 0);
        EXPECT_THAT(help.out, HasSubstr("lancer " + command)) << command;
        EXPECT_THAT(help.err, IsEmpty());
        EXPECT_THAT(place.run({command, "--version"}).out, StartsWith("lancer ")) << command;
        EXPECT_THAT(place.run({"--help"}).out, HasSubstr("  " + command + " "));
    }
}

TEST(Commands, WrongUseIsTwo) {
    const Workplace place;
    EXPECT_EQ(place.run({}).code, 2);
    const Finished unknown = place.run({"rendr", "a.lancer"});
    EXPECT_EQ(unknown.code, 2);
    EXPECT_THAT(unknown.err, HasSubstr("there is no command 'rendr'"));
    for (const std::string& command : commands) {
        EXPECT_EQ(place.run({command}).code, 2) << command;
        EXPECT_EQ(place.run({command, "--bogus"}).code, 2) << command;
    }
    EXPECT_THAT(place.run({"render", "a.lancer", "--siz", "8x8"}).err,
                HasSubstr("'render' has no option '--siz': did you mean '--size'?"));
    for (const char* habit : {"--width", "--height=480", "--resolution"}) {
        EXPECT_THAT(place.run({"render", "a.lancer", habit, "640"}).err,
                    HasSubstr("use --size 640x480 for the size of a picture"));
    }
    EXPECT_THAT(place.run({"render", "a.lancer", "--spp", "4"}).err, HasSubstr("--samples 3"));
    EXPECT_THAT(place.run({"check", "a.lancer", "--width", "4"}).err, Not(HasSubstr("--size")));
    EXPECT_THAT(place.run({"render", "a.lancer", "b.lancer"}).err,
                HasSubstr("unexpected argument 'b.lancer'"));
}

TEST(Commands, AFileThatCannotBeReadIsFour) {
    const Workplace place;
    for (const std::string& command : commands) {
        const Finished finished = place.run({command, "nowhere.png", "nowhere.png"});
        if (command == "check" || command == "compare") {
            EXPECT_EQ(finished.code, 4) << command;
        }
        if (command != "compare") {
            const Finished single = place.run({command, "nowhere.lancer"});
            EXPECT_EQ(single.code, 4) << command;
            EXPECT_THAT(single.err, HasSubstr("nowhere.lancer"));
            EXPECT_EQ(place.run({command, "."}).code, 4) << "a folder";
        }
    }
}

TEST(Commands, AnInterruptLeavesNothingBehind) {
    // A fake POV-Ray that sends the signal of Ctrl-C.
    const Workplace place;
    place.write("a.lancer", small_scene());
    place.write("povray",
                "#!/bin/sh\n[ \"$1\" = --version ] && echo 'POV-Ray 3.7.0.10' && exit\n"
                "touch half-a-picture; ls -d \"$TMPDIR\"/* > \"$TMPDIR/../seen\"\n"
                "kill -INT $PPID; exec sleep 20\n");
    fs::permissions(place.path("povray"), fs::perms::owner_all);
    fs::create_directory(place.path("tmp"));
    const Finished finished =
        place.run({"validate", "--no-cache", "a.lancer"}, "",
                  {"LANCER_POVRAY=" + place.path("povray"), "TMPDIR=" + place.path("tmp")});
    EXPECT_EQ(finished.code, 130) << finished.err;
    EXPECT_THAT(place.read("seen"), HasSubstr("lancer-"));
    for (int i = 0; i < 1000 && !fs::is_empty(place.path("tmp")); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_TRUE(fs::is_empty(place.path("tmp")));
}

TEST(Commands, AnEmptySceneIsNoMistake) {
    const Workplace place;
    const Finished finished = place.run({"check", "-"}, "");
    EXPECT_EQ(finished.code, 0);
    EXPECT_THAT(finished.err, HasSubstr("warning: the scene has no camera"));
    EXPECT_THAT(finished.err, HasSubstr("warning: the scene has no light"));
}

TEST(Commands, CheckCountsAllWarningsOnce) {
    const Workplace place;
    const Finished finished =
        place.run({"check", "-"}, "camera c { position [0, 0, 5] look_at [0, 0, 0] fov 1 }");
    EXPECT_EQ(finished.code, 0);
    EXPECT_THAT(finished.err, HasSubstr("'fov 1' is very narrow"));
    EXPECT_TRUE(finished.err.ends_with("\n2 warnings\n")) << finished.err;
}

TEST(Commands, CheckReadsAllScenesAndTellsTheWorst) {
    const Workplace place;
    place.write("good.lancer", small_scene());
    place.write("bad.lancer", "sphere { raduis 1 }\nspere { }\n");
    EXPECT_EQ(place.run({"check", "good.lancer"}).code, 0);
    const Finished both = place.run({"check", "bad.lancer", "good.lancer"});
    EXPECT_EQ(both.code, 3);
    EXPECT_THAT(both.err, HasSubstr("bad.lancer:1:10: error: "));
    EXPECT_THAT(both.err, HasSubstr("bad.lancer:2:1: error: "));
    EXPECT_THAT(both.out, HasSubstr("good.lancer: no errors"));
    const Finished missing = place.run({"check", "nowhere.lancer", "bad.lancer", "good.lancer"});
    EXPECT_EQ(missing.code, 4);
    EXPECT_THAT(missing.err, HasSubstr("bad.lancer:1:10: error: "));
    EXPECT_THAT(place.files(), ElementsAre("bad.lancer", "good.lancer"));
}

TEST(Commands, AFileIsOneWhateverLinkNamesIt) {
    const Workplace place;
    place.write("a.lancer", "let a = 1");
    std::filesystem::create_symlink("a.lancer", place.path("b.lancer"));
    place.write("twice.lancer", "include \"a.lancer\" include \"b.lancer\" print a");
    EXPECT_EQ(place.run({"check", "twice.lancer"}).code, 0);
    // A folder that contains a link to itself has a new path for each round of a cycle.
    std::filesystem::create_symlink(".", place.path("here"));
    place.write("cycle.lancer", "include \"here/cycle.lancer\"");
    EXPECT_THAT(place.run({"check", "cycle.lancer"}).err,
                HasSubstr("cycle: cycle.lancer -> cycle.lancer"));
    // The parent of a linked folder is where that folder is.
    std::filesystem::create_directories(place.path("far/away"));
    place.write("far/b.lancer", "print \"the far one\"");
    std::filesystem::create_symlink("far/away", place.path("near"));
    place.write("up.lancer", "include \"near/../b.lancer\"");
    EXPECT_THAT(place.run({"check", "up.lancer"}).err, HasSubstr("the far one"));
}

TEST(Commands, ALimitCanBeRaised) {
    const Workplace place;
    const std::string scene =
        "def down(n) { if n > 0 { down(n - 1) } }\n"
        "down(2000)\n" +
        small_scene();
    EXPECT_EQ(place.run({"check", "-"}, scene).code, 3);
    const Finished raised =
        place.run({"check", "-", "--limit-calls", "100000", "--limit-nesting", "100000"}, scene);
    EXPECT_EQ(raised.code, 0) << raised.err;
}

TEST(Commands, InfoTellsWhatTheSceneHoldsAndWhoAsksForWhat) {
    const Workplace place;
    place.write("a.lancer", small_scene() +
                                "sphere { radius 0.2 name \"drop\"\n"
                                "  material { transmission 0.9 ior 1.3 } }\n");
    const Finished text = place.run({"info", "a.lancer"});
    EXPECT_EQ(text.code, 0) << text.err;
    EXPECT_THAT(text.out, HasSubstr("2 spheres, 1 box, 1 plane"));
    EXPECT_THAT(text.out, HasSubstr("a.lancer:11:1: sphere \"drop\""));
    EXPECT_THAT(text.out, HasSubstr(" s before the first ray, once for each part: parse 0."));

    const Finished finished = place.run({"info", "--json", "a.lancer"});
    const nlohmann::json json = nlohmann::json::parse(finished.out);
    EXPECT_EQ(json.at("shapes").at("sphere"), 2);
    EXPECT_EQ(json.at("cameras").size(), 2u);
    EXPECT_EQ(json.at("level"), name_of(best_level()));
    for (const char* step : {"parse", "evaluate", "build"}) {
        EXPECT_GT(json.at("fixed_cost").at(step), 0);
        EXPECT_LT(json.at("fixed_cost").at(step), 10);
    }
    std::vector<std::string> features;
    for (const auto& requirement : json.at("requires"))
        features.push_back(requirement.at("feature"));
    EXPECT_THAT(features, ElementsAre("shadows", "filtered shadows", "reflection", "transmission",
                                      "media", "refraction"));
}

TEST(Commands, CompareTellsEqualFromDifferent) {
    const Workplace place;
    place.write("a.lancer", small_scene());
    ASSERT_EQ(place.run({"render", "a.lancer", "-o", "a.png"}).code, 0);
    ASSERT_EQ(place.run({"render", "a.lancer", "-o", "b.png", "-D", "size=0.7"}).code, 0);
    EXPECT_EQ(place.run({"compare", "a.png", "a.png"}).code, 0);
    const Finished different =
        place.run({"compare", "a.png", "b.png", "-o", "heat.png", "--json", "c.json"});
    EXPECT_EQ(different.code, 1);
    EXPECT_EQ(nlohmann::json::parse(place.read("c.json")).at("verdict"), "fail");
    EXPECT_TRUE(place.exists("heat.png"));
    EXPECT_EQ(place.run({"compare", "a.png", "b.png", "--fail", "2"}).code, 0);
    EXPECT_EQ(place.run({"compare", "a.png", "b.png", "-o", "nowhere/heat.png"}).code, 4);
    const std::string picture = place.read("a.png");
    EXPECT_EQ(place.run({"compare", "a.png", "b.png", "-o", "a.png"}).code, 2);
    EXPECT_EQ(place.read("a.png"), picture);
    const Finished json = place.run({"compare", "a.png", "b.png", "--json", "-"});
    EXPECT_EQ(nlohmann::json::parse(json.out).at("verdict"), "fail");
}

TEST(Commands, CompareTakesMasksOfPicturesAndOfFolders) {
    const Workplace place;
    place.write("a.lancer", small_scene());
    for (const char* folder : {"one", "two", "masks"}) fs::create_directory(place.path(folder));
    ASSERT_EQ(place.run({"render", "a.lancer", "-o", "one/a.png"}).code, 0);
    ASSERT_EQ(place.run({"render", "a.lancer", "-o", "two/a.png", "-D", "size=0.805"}).code, 0);
    // Black except for the upper left corner, where there is only background. A PPM has no curve.
    std::string mask = "P2 64 48 1";
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x) mask += x < 4 && y < 4 ? " 1" : " 0";
    place.write("corner.ppm", mask);
    EXPECT_EQ(place.run({"compare", "one/a.png", "two/a.png"}).code, 1);
    const Finished masked =
        place.run({"compare", "one/a.png", "two/a.png", "--mask", "corner.ppm"});
    EXPECT_EQ(masked.code, 0) << masked.out << masked.err;
    EXPECT_THAT(masked.out, HasSubstr("16 pixels compared, 3056 left out"));
    EXPECT_EQ(place.run({"compare", "one", "two", "--mask", "corner.ppm", "-q"}).code, 0);
    EXPECT_EQ(place.run({"compare", "one", "two", "--mask", "masks", "-q"}).code, 1)
        << "a picture without a mask is compared whole";
    fs::copy_file(place.path("corner.ppm"), place.path("masks/a.png"));
    EXPECT_EQ(place.run({"compare", "one", "two", "--mask", "masks", "-q"}).code, 0);
    EXPECT_EQ(place.run({"compare", "one/a.png", "two/a.png", "--mask", "nowhere.png"}).code, 4);
    const std::string before = place.read("corner.ppm");
    EXPECT_EQ(
        place.run({"compare", "one/a.png", "two/a.png", "--mask", "corner.ppm", "-o", "corner.ppm"})
            .code,
        2);
    EXPECT_EQ(place.read("corner.ppm"), before);
    const Finished edges = place.run({"compare", "one/a.png", "two/a.png", "--fail", "0.05",
                                      "--edges", "--window", "8", "--fail-window", "50"});
    EXPECT_EQ(edges.code, 0) << edges.out;
    EXPECT_THAT(edges.out, HasSubstr("an edge is displaced by up to a pixel, which is allowed"));
}

TEST(Commands, CompareNamesTwoEncodings) {
    const Workplace place;
    place.write("a.lancer", small_scene());
    for (const char* output : {"a.png", "a.exr", "a.ppm", "a.tif"})
        ASSERT_EQ(place.run({"render", "a.lancer", "-o", output}).code, 0);
    ASSERT_EQ(place.run({"render", "a.lancer", "-o", "linear.png", "--linear"}).code, 0);
    // The picture as written by a program without sRGB chunks: gAMA 0.45455 instead.
    std::string png = place.read("a.png");
    const std::string srgb_chunk = png.substr(png.find("sRGB") - 4, 13);
    png.replace(png.find(srgb_chunk), 13, std::string("\0\0\0\4gAMA\0\0\xB1\x8F\v\xFC\x61\5", 16));
    place.write("gamma.png", png);
    const auto said = [&](const char* a, const char* b) {
        return place.run({"compare", a, b, "--fail", "1"}).out;
    };
    EXPECT_THAT(said("a.png", "gamma.png"), HasSubstr("curves  sRGB against gAMA 0.45455: "));
    EXPECT_THAT(said("linear.png", "a.png"), HasSubstr("curves  linear against sRGB: "));
    EXPECT_THAT(said("a.png", "a.exr"), HasSubstr("curves  sRGB against linear: "));
    EXPECT_THAT(said("a.png", "a.ppm"), Not(HasSubstr("curves")));
    EXPECT_THAT(said("a.exr", "a.tif"), HasSubstr("curves  linear against sRGB: "));
    EXPECT_THAT(said("a.exr", "linear.png"), Not(HasSubstr("curves")));
}

}  // namespace
}  // namespace lancer::cli
