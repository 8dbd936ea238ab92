// No command overwrites one of its inputs, or an output by another output.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>

#include "tests/cli/run_lancer.h"

namespace lancer::cli {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

/// A scene that reads a file of each kind, and pictures to compare.
class Overwriting : public testing::Test {
  protected:
    Overwriting() {
        place_.write("part.lancer", "sphere { radius 0.1 material { color tiles } }\n");
        place_.write("mesh.obj",
                     "mtllib paint.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl red\n"
                     "f 1/1 2/1 3/1\n");
        place_.write("paint.mtl", "newmtl red\nmap_Kd paint.png\n");
        place_.write("a.lancer", small_scene());
        EXPECT_EQ(place_.run({"render", "a.lancer", "-o", "image.png", "--size", "4x4"}).code, 0);
        place_.write("paint.png", place_.read("image.png"));
        place_.write("a.lancer", "print \"evaluated\"\n" + small_scene() + R"(
texture tiles { image "image.png" }
mesh { file "mesh.obj" }
include "part.lancer"
)");
        place_.write("a.expect", "unexplained 3  # as a test\n");
        fs::create_symlink("a.lancer", place_.path("link.png"));
        fs::create_symlink(".", place_.path("here"));
        fs::create_hard_link(place_.path("image.png"), place_.path("hard.png"));
        remember();
    }

    /// Runs the command, and expects a usage error before anything was done.
    void refused(const std::vector<std::string>& arguments, const std::string& message) {
        std::string command;
        for (const std::string& argument : arguments) command += argument + " ";
        const Finished finished = place_.run(arguments, place_.read("a.lancer"));
        EXPECT_EQ(finished.code, 2) << command << finished.err;
        EXPECT_THAT(finished.err, HasSubstr(message)) << command;
        EXPECT_THAT(finished.out, Not(HasSubstr("wrote"))) << command;
        const std::map<std::string, std::string> before = files_;
        remember();
        EXPECT_EQ(files_, before) << command;
    }

    /// The files that must not change.
    void remember() {
        files_.clear();
        for (const std::string& name : place_.files())
            files_[name] = name == "here" ? "" : place_.read(name);
    }
    Workplace place_;

  private:
    std::map<std::string, std::string> files_;
};

const std::vector<std::string> all_inputs{"a.lancer",      "part.lancer", "mesh.obj",  "image.png",
                                          "here/mesh.obj", "link.png",    "paint.mtl", "paint.png"};

TEST_F(Overwriting, StatisticsSpareAllThatTheSceneReads) {
    for (const std::string& name : all_inputs) {
        refused({"render", "a.lancer", "-o", "new.png", "--stats", name},
                "'" + name + "' would overwrite");
    }
    refused({"render", "a.lancer", "-o", "new.png", "--stats", "new.png"},
            "'new.png' would be written twice, for -o and for --stats");
    refused({"render", "a.lancer", "-o", "new.png", "--stats", "here/./new.png"}, "written twice");
    refused({"render", "a.lancer", "-o", "f%d.png", "--frames", "1..3", "--stats", "f3.png"},
            "written twice, for frame 3 and for --stats");
}

TEST_F(Overwriting, PicturesSpareAllThatTheSceneReads) {
    for (const char* name : {"image.png", "here/image.png", "link.png", "hard.png", "paint.png"})
        refused({"render", "a.lancer", "-o", name}, "would overwrite");
    refused({"render", "a.lancer", "-o", "image%d.png", "--frames", "1..3", "--stats", "mesh.obj"},
            "'mesh.obj' would overwrite 'mesh.obj', which is an input");
}

TEST_F(Overwriting, FramesSpareEachOther) {
    fs::create_symlink("f1.png", place_.path("f2.png"));
    EXPECT_EQ(place_.run({"render", "a.lancer", "-o", "f%d.png", "--frames", "1..2"}).code, 2);
    EXPECT_FALSE(place_.exists("f1.png"));
}

TEST_F(Overwriting, NoFrameReplacesWhatAnotherOneShows) {
    place_.write("b.lancer", small_scene() + "texture t { image \"f1.png\" }\n");
    place_.write("f1.png", place_.read("image.png"));
    const Finished finished =
        place_.run({"render", "b.lancer", "-o", "f%d.png", "--frames", "0..1"});
    EXPECT_EQ(finished.code, 2) << finished.err;
    EXPECT_FALSE(place_.exists("f0.png"));
    EXPECT_EQ(place_.read("f1.png"), place_.read("image.png"));
}

TEST_F(Overwriting, StabilitySparesAllThatTheSceneReads) {
    for (const std::string& name : all_inputs)
        refused({"stability", "a.lancer", "--no-povray", "--json", name}, "would overwrite");
    refused({"stability", "a.lancer", "--no-povray", "--json", "s.svg", "--plot", "s.svg"},
            "written twice, for --json and for --plot");
}

TEST_F(Overwriting, ValidationSparesAllThatTheScenesRead) {
    for (const std::string& name : all_inputs)
        refused({"validate", "a.lancer", "--json", name}, "would overwrite");
    refused({"validate", "a.lancer", "--json", "a.expect"}, "would overwrite");
    place_.write("b.lancer", small_scene());
    EXPECT_EQ(place_.run({"validate", "a.lancer", "b.lancer", "--json", "b.lancer"}).code, 2);
    EXPECT_EQ(place_.read("b.lancer"), small_scene());
    fs::create_directory(place_.path("report"));
    fs::create_symlink("../mesh.obj", place_.path("report/index.html"));
    EXPECT_EQ(place_.run({"validate", "a.lancer", "--report", "report"}).code, 2);
    EXPECT_EQ(place_
                  .run({"validate", "b.lancer", "--report", "report", "--json",
                        "report/../report/index.html"})
                  .code,
              2);
}

TEST_F(Overwriting, AComparisonSparesBothSides) {
    place_.write("b.png", place_.read("image.png"));
    remember();
    for (const char* name : {"image.png", "b.png", "hard.png", "here/b.png"}) {
        refused({"compare", "image.png", "b.png", "-o", name}, "would overwrite");
        refused({"compare", "image.png", "b.png", "--json", name}, "would overwrite");
    }
    refused({"compare", "image.png", "b.png", "-o", "c.png", "--json", "c.png"}, "written twice");
    for (const char* folder : {"one", "two"}) {
        fs::create_directory(place_.path(folder));
        place_.write(std::string(folder) + "/a.png", place_.read("image.png"));
    }
    fs::create_symlink("a.png", place_.path("one/index.html"));
    EXPECT_EQ(place_.run({"compare", "one", "two", "--report", "one"}).code, 2);
    EXPECT_EQ(place_.read("one/a.png"), place_.read("image.png"));
    EXPECT_EQ(place_.run({"compare", "one", "two", "--report", "two"}).code, 0);
}

TEST_F(Overwriting, StandardInputAndOutputAreFilesToo) {
    // Standard input of `refused` is a file of the test's own.
    const std::string in = place_.path("../said/in");
    refused({"render", "-", "-o", "new.png", "--stats", in},
            "overwrite standard input, which is an input");
    place_.write("../said/out", "");
    fs::create_hard_link(place_.path("../said/out"), place_.path("out.lancer"));
    const Finished finished = place_.run({"check", "out.lancer"});
    EXPECT_EQ(finished.code, 2) << finished.err;
    EXPECT_THAT(finished.err, HasSubstr("standard output would overwrite 'out.lancer'"));
}

TEST_F(Overwriting, DevicesTakeWhatTheyAreGiven) {
    EXPECT_EQ(place_.run({"render", "a.lancer", "-o", "/dev/null", "--stats", "/dev/null"}).code,
              0);
    const Finished both = place_.run({"render", "a.lancer", "-o", "/dev/stdout", "--stats", "-"});
    EXPECT_EQ(both.code, 2);
    EXPECT_THAT(both.err, HasSubstr("standard output would be written twice"));
}

}  // namespace
}  // namespace lancer::cli
