// Parts of a picture, joined and resumed, as several machines draw them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>

#include <chrono>
#include <filesystem>
#include <thread>

#include "tests/cli/run_lancer.h"

namespace lancer::cli {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

using Words = std::vector<std::string>;

class Parts : public testing::Test {
  protected:
    Parts() { place_.write("a.lancer", small_scene()); }

    Finished render(const Words& options) const {
        Words words{"render", "a.lancer"};
        words.insert(words.end(), options.begin(), options.end());
        return place_.run(words);
    }
    std::string part_name(int number) const { return "p" + std::to_string(number) + ".exr"; }
    Finished draw(int number, int count, Words options = {}) const {
        options.insert(options.end(),
                       {"--part", std::to_string(number) + "/" + std::to_string(count), "-o",
                        part_name(number)});
        return render(options);
    }
    void draw_all(int count, const Words& options = {}) const {
        for (int number = 1; number <= count; ++number) {
            const Finished finished = draw(number, count, options);
            ASSERT_EQ(finished.code, 0) << finished.err;
        }
    }
    Finished join(const std::string& output, int count, const Words& options = {}) const {
        Words words{"join", "-o", output};
        for (int number = count; number >= 1; --number) words.push_back(part_name(number));
        words.insert(words.end(), options.begin(), options.end());
        return place_.run(words);
    }
    /// The command is refused with this code and message, and writes nothing.
    void refused(const Finished& finished, int code, const std::string& message,
                 const std::string& output = "out.png") const {
        EXPECT_EQ(finished.code, code) << finished.err;
        EXPECT_THAT(finished.err, HasSubstr(message));
        EXPECT_FALSE(place_.exists(output));
    }
    Workplace place_;
};

TEST_F(Parts, JoinedAreTheBytesOfTheWhole) {
    const Words options{"--samples", "2", "--sampling", "sobol"};
    draw_all(5, options);
    for (const Words& encoding :
         {Words{"out.png"}, Words{"out.png", "--bits", "16"}, Words{"out.ppm", "--linear"},
          Words{"out.exr"}, Words{"out.tif"}, Words{"out.hdr"}, Words{"out.jpg"}}) {
        const Words rest(encoding.begin() + 1, encoding.end());
        const Finished joined = join(encoding[0], 5, rest);
        ASSERT_EQ(joined.code, 0) << joined.err;
        EXPECT_THAT(joined.out, HasSubstr("(64x48) from 5 parts"));
        Words whole = options;
        whole.insert(whole.end(), {"-o", "whole" + encoding[0].substr(3)});
        whole.insert(whole.end(), rest.begin(), rest.end());
        ASSERT_EQ(render(whole).code, 0);
        EXPECT_TRUE(place_.read(encoding[0]) == place_.read(whole[5])) << encoding[0];
    }
}

TEST_F(Parts, HaveTheChannelsOfAovAndFollowACropOfAPreview) {
    const Words options{"--aov", "--size", "200x160", "--crop", "16,12,101,99", "--preview"};
    draw_all(3, options);
    ASSERT_EQ(join("out.exr", 3).code, 0);
    Words whole = options;
    whole.insert(whole.end(), {"-o", "whole.exr"});
    ASSERT_EQ(render(whole).code, 0);
    EXPECT_TRUE(place_.read("out.exr") == place_.read("whole.exr"));
    refused(join("out.png", 3), 2, "--aov needs an .exr");
}

TEST_F(Parts, AreTheSameBytesForAnyNumberOfThreads) {
    draw(2, 3, {"--threads", "1"});
    const std::string one = place_.read("p2.exr");
    draw(2, 3, {"--threads", "4", "--level", "scalar"});
    EXPECT_TRUE(one == place_.read("p2.exr"));
}

TEST_F(Parts, OfAnErrorTellThatOfTheWhole) {
    const Words options{"--max-error", "0.02"};
    const Finished at_once = render({"--max-error", "0.02", "-o", "whole.png"});
    ASSERT_EQ(at_once.code, 0);
    const std::string told = at_once.out.substr(at_once.out.find('\n'));
    draw_all(1, options);
    const Finished single = join("out.png", 1);
    EXPECT_EQ(single.code, 0) << single.err;
    EXPECT_EQ(single.out.substr(single.out.find('\n')), told);
    EXPECT_TRUE(place_.read("out.png") == place_.read("whole.png")) << "text of the PNG included";

    EXPECT_THAT(draw(3, 3, options).out, HasSubstr("this part: RMSE 0.0"));
    ASSERT_EQ(draw(1, 3, options).code, 0);
    ASSERT_EQ(draw(2, 3, options).code, 0);
    const std::string bytes = place_.read("p3.exr");
    ASSERT_EQ(draw(3, 3, {"--max-error", "0.02", "--threads", "1"}).code, 0);
    EXPECT_TRUE(bytes == place_.read("p3.exr")) << "the same for any number of threads";
    const Finished joined = join("out.png", 3);
    EXPECT_EQ(joined.code, 0) << joined.err;
    EXPECT_THAT(joined.out, HasSubstr("from 3 parts"));
    EXPECT_THAT(joined.out, HasSubstr("steps of 8 bits), asked 0.02; "));
    EXPECT_THAT(joined.out, Not(HasSubstr("this part")));
    ASSERT_EQ(join("out.exr", 3).code, 0);
    for (const char* name :
         {"error.asked", "error.rmse", "error.low", "error.high", "rays.per_pixel"}) {
        EXPECT_THAT(place_.read("out.png"), HasSubstr("lancer:" + std::string(name)));
        EXPECT_THAT(place_.read("out.exr"), HasSubstr("lancer:" + std::string(name)));
    }
    EXPECT_THAT(draw(3, 3, {"--max-error", "0.02", "--resume"}).out, HasSubstr("kept p3.exr"));
}

TEST_F(Parts, OfAnotherErrorAreRefused) {
    for (const char* number : {"1", "2", "3"}) {
        const std::string error = number == std::string("2") ? "0.05" : "0.06";
        ASSERT_EQ(draw(number[0] - '0', 3, {"--max-error", error, "--no-audit"}).code, 0);
    }
    refused(join("out.png", 3), 4, "it is of other options (");
    EXPECT_THAT(join("out.png", 3).err, HasSubstr("error 0.05"));
    EXPECT_THAT(join("out.png", 3).err, HasSubstr("error 0.06"));
}

/// Specks that only single rays meet: no error is told. The parts are still complete; the joined
/// picture misses its target.
TEST_F(Parts, DoNotFailByTheirErrorAndTheJoinedPictureDoes) {
    place_.write("a.lancer",
                 "camera { position [0, 0, 10] look_at [0, 0, 0] }\n"
                 "for i in 0..9 { for j in 0..9 { sphere { center [i - 4.4, j - 4.3, 0] radius "
                 "0.006 material { emission 60 } } } }\n"
                 "image { width 96 height 96 }\n");
    const Words options{"--max-error", "0.02"};
    ASSERT_EQ(render({"--max-error", "0.02", "-o", "whole.png"}).code, 1);
    draw_all(2, options);
    const Finished joined = join("out.png", 2);
    EXPECT_EQ(joined.code, 1) << joined.out << joined.err;
    EXPECT_THAT(joined.out, HasSubstr("the error is not known"));
    EXPECT_TRUE(place_.exists("out.png"));
}

TEST_F(Parts, OfAShareOffAndWithChannels) {
    draw_all(2, {"--max-off", "4%:4"});
    const Finished joined = join("out.png", 2);
    EXPECT_EQ(joined.code, 0) << joined.err;
    EXPECT_THAT(joined.out, HasSubstr("of the pixels are off by more than 4 steps of 8 bits"));
    EXPECT_THAT(place_.read("out.png"), HasSubstr("lancer:off.high"));
    draw_all(1, {"--max-off", "2%:3", "--no-audit", "--aov"});
    EXPECT_THAT(join("out.exr", 1).out, HasSubstr("not audited"));
    ASSERT_EQ(render({"--max-off", "2%:3", "--no-audit", "--aov", "-o", "whole.exr"}).code, 0);
    EXPECT_TRUE(place_.read("out.exr") == place_.read("whole.exr"));
    draw_all(3, {"--max-error", "0.05", "--aov", "--no-audit"});
    EXPECT_EQ(join("out.exr", 3).code, 0);
    EXPECT_EQ(place_.image("out.exr").extra_names.size(), 8U);
}

/// A picture may have more parts than a process may have open files.
TEST_F(Parts, AreMoreThanOpenFiles) {
    draw_all(48, {"--size", "16x48"});
    Words words{"join", "-o", "out.png", "-q"};
    for (int number = 1; number <= 48; ++number) words.push_back(part_name(number));
    Surroundings few;
    few.limits = "-n 20";
    const Finished joined = place_.run_in(few, words);
    ASSERT_EQ(joined.code, 0) << joined.err;
    ASSERT_EQ(render({"--size", "16x48", "-o", "whole.png"}).code, 0);
    EXPECT_TRUE(place_.read("out.png") == place_.read("whole.png"));
}

TEST_F(Parts, ThatAreMissingAreNamed) {
    draw_all(1);
    ASSERT_EQ(draw(1, 7).code, 0);
    ASSERT_EQ(draw(3, 7).code, 0);
    refused(place_.run({"join", "p1.exr", "p3.exr", "-o", "out.png"}), 75,
            "of 7 parts, these are missing: 2, 4 to 7");
}

TEST_F(Parts, OfOtherPicturesAreRefused) {
    draw_all(3);
    const auto stranger = [&](const Words& options, const std::string& message, int count = 3) {
        ASSERT_EQ(draw(2, count, options).code, 0);
        refused(join("out.png", 3), 4, message);
    };
    stranger({"--samples", "2"}, "it is of other options (size 64x48");
    stranger({"--size", "65x48"}, "other options (size 65x48");
    stranger({"-D", "size=0.3"}, "another scene");
    stranger({}, "it is of 4 parts, not 3", 4);
    ASSERT_EQ(draw(2, 3).code, 0);
    fs::copy_file(place_.path("p1.exr"), place_.path("twice.exr"));
    refused(place_.run({"join", "p1.exr", "p2.exr", "twice.exr", "p3.exr", "-o", "out.png"}), 4,
            "'p1.exr' and 'twice.exr' are both part 1 of 3");
    std::string other_build = place_.read("p2.exr");
    const std::size_t build = other_build.find("\nbuild ") + 7;
    other_build[build] = other_build[build] == '0' ? '1' : '0';
    place_.write("p2.exr", other_build);
    refused(join("out.png", 3), 4, "it is of another build of lancer");
    place_.write("a.lancer", small_scene() + "sphere { radius 0.1 }\n");
    stranger({}, "another scene");
}

TEST_F(Parts, ThatAreDamagedAreRefused) {
    draw_all(2);
    std::string bytes = place_.read("p2.exr");
    bytes[bytes.size() - 5] = static_cast<char>(bytes[bytes.size() - 5] ^ 1);
    place_.write("p2.exr", bytes);
    refused(join("out.png", 2), 4, "'p2.exr' is damaged: render this part again");
    refused(join("out.exr", 2), 4, "'p2.exr' is damaged", "out.exr");
    place_.write("p2.exr", bytes.substr(0, bytes.size() / 2));
    refused(join("out.png", 2), 4, "'p2.exr' is damaged");
    place_.write("p2.exr", "no picture");
    refused(join("out.png", 2), 4, "'p2.exr' is damaged, or not a part of a picture");
    refused(join("p1.exr", 2), 2, "'p1.exr' would overwrite 'p1.exr', which is an input",
            "out.png");
}

TEST_F(Parts, WrongUse) {
    const std::vector<std::pair<Words, std::string>> cases{
        {{"--part", "0/3"}, "there is no part 0 of 3"},
        {{"--part", "4/3"}, "there is no part 4 of 3"},
        {{"--part", "1/0"}, "expected K/N"},
        {{"--part", "three"}, "expected K/N"},
        {{"--part", "1/3", "--time", "1"}, "--part cannot be used with --time"},
        {{"--part", "1/3", "--passes", "3"}, "--part cannot be used with --passes"},
        {{"--part", "1/3", "--max-error", "1e-6"}, "rays per pixel in this part; about "},
        {{"--part", "1/3", "-o", "a.png"}, "--part needs an .exr file"},
        {{"--part", "1/3", "--bits", "16"}, "give --bits and --linear to join"},
        {{"--part", "1/49"}, "cannot have more parts than rows"},
        {{"--resume", "--time", "1"}, "--resume cannot know"},
        {{"--resume", "-o", "a.jpg"}, "--resume needs a .png or .exr file"}};
    for (const auto& [options, message] : cases) {
        const Finished finished = render(options);
        EXPECT_EQ(finished.code, 2) << message;
        EXPECT_THAT(finished.err, HasSubstr(message));
    }
    EXPECT_EQ(place_.files(), Words{"a.lancer"});
}

TEST_F(Parts, AnAnimationsFramesAreDealt) {
    for (const char* part : {"1/3", "2/3", "3/3"})
        ASSERT_EQ(render({"--frames", "1..5", "--part", part, "-o", "f-%d.png"}).code, 0);
    ASSERT_EQ(render({"--frames", "1..5", "-o", "g-%d.png"}).code, 0);
    for (const char* frame : {"1", "2", "3", "4", "5"}) {
        EXPECT_TRUE(place_.read("f-" + std::string(frame) + ".png") ==
                    place_.read("g-" + std::string(frame) + ".png"));
    }
    const Words before = place_.files();
    fs::remove(place_.path("f-2.png"));
    fs::remove(place_.path("f-5.png"));
    EXPECT_THAT(render({"--frames", "1..5", "--part", "2/3", "-o", "f-%d.png"}).out,
                HasSubstr("wrote 2 pictures"));
    EXPECT_EQ(place_.files(), before);
}

using Resume = Parts;

TEST_F(Resume, WhatShowsNothingIsNoOtherScene) {
    const Words options{"--resume"};
    place_.write("shine.ppm", "P6 1 1 255\nabc");
    const std::string ball =
        "sphere { radius 0.2 center [1, 1, 0] material { color texture { image \"shine.ppm\" } } "
        "}\n";
    place_.write("a.lancer", small_scene() + ball);
    ASSERT_EQ(draw(1, 2, options).code, 0);
    place_.write("a.lancer",
                 "// another word\nlet one = 1\n" + small_scene() +
                     "for i in 0..1 { sphere { name \"ball\" radius 0.1 + 0.1 "
                     "center [one, 1, i * 5] material { color texture { image \"shine.ppm\" } } } "
                     "}\n");
    EXPECT_THAT(draw(1, 2, options).out, HasSubstr("kept p1.exr"));
    place_.write("shine.ppm", "P6 1 1 255\nabd");
    EXPECT_THAT(draw(1, 2, options).err, HasSubstr("rendered again: it is of another scene"));
}

TEST_F(Resume, APartIsDrawnOnceAndAgainWhenSomethingHasChanged) {
    const Words options{"--resume"};
    EXPECT_THAT(draw(1, 2, options).out, HasSubstr("wrote p1.exr"));
    const std::string first = place_.read("p1.exr");
    EXPECT_THAT(draw(1, 2, options).out, HasSubstr("kept p1.exr"));
    EXPECT_TRUE(first == place_.read("p1.exr"));
    EXPECT_THAT(draw(1, 3, options).err, HasSubstr("p1.exr is rendered again: it is part 1 of 2"));
    EXPECT_THAT(draw(1, 3, {"--resume", "--samples", "2"}).err,
                HasSubstr("p1.exr is rendered again: it is of other options"));
    place_.write("p1.exr", place_.read("p1.exr").substr(0, 5000));
    EXPECT_THAT(draw(1, 2, options).err, HasSubstr("is damaged"));
    EXPECT_TRUE(first == place_.read("p1.exr"));
}

TEST_F(Resume, FramesAreKeptUntilTheSceneOrAFileOfItChanges) {
    place_.write("part.lancer", "sphere { radius 0.1 center [0, 1, frame / 9] }\n");
    place_.write("a.lancer", small_scene() + "include \"part.lancer\"\n");
    const Words animation{"--frames", "1..4", "--resume", "-o", "f-%d.png"};
    EXPECT_THAT(render(animation).out, HasSubstr("wrote 4 pictures,"));
    const Finished again = render(animation);
    EXPECT_THAT(again.out, HasSubstr("wrote 0 pictures, kept 4,"));
    EXPECT_EQ(again.err, "");
    const std::string third = place_.read("f-3.png");
    fs::remove(place_.path("f-3.png"));
    std::string damaged = place_.read("f-2.png");
    damaged[damaged.size() / 2] = static_cast<char>(damaged[damaged.size() / 2] ^ 4);
    place_.write("f-2.png", damaged);
    const Finished mended = render(animation);
    EXPECT_THAT(mended.out, HasSubstr("wrote 2 pictures, kept 2,"));
    EXPECT_THAT(mended.err, HasSubstr("f-2.png is rendered again: it is damaged"));
    EXPECT_TRUE(place_.read("f-3.png") == third);
    place_.write("part.lancer", "sphere { radius 0.2 center [0, 1, frame / 9] }\n");
    const Finished changed = render(animation);
    EXPECT_THAT(changed.out, HasSubstr("wrote 4 pictures,"));
    EXPECT_THAT(changed.err, HasSubstr("f-4.png is rendered again: it is of another scene"));
}

TEST_F(Resume, APictureWithoutResumeKeepsItsBytes) {
    ASSERT_EQ(render({"-o", "plain.png"}).code, 0);
    ASSERT_EQ(render({"-o", "told.png", "--resume"}).code, 0);
    EXPECT_THAT(place_.read("plain.png"), Not(HasSubstr("lancer:origin")));
    EXPECT_EQ(place_.image("plain.png").data, place_.image("told.png").data);
    EXPECT_THAT(render({"-o", "plain.png", "--resume"}).err,
                HasSubstr("it is damaged, or was not written by a run with --resume"));
}

TEST(Killed, PartsAndFramesAtAnyMomentAndResumed) {
    const Workplace place;
    place.write("a.lancer", small_scene());
    ASSERT_EQ(place.run({"render", "a.lancer", "-o", "whole.png", "--size", "160x120"}).code, 0);
    const auto part = [](int number) {
        return Words{"render",
                     "a.lancer",
                     "--size",
                     "160x120",
                     "--resume",
                     "--part",
                     std::to_string(number) + "/3",
                     "-o",
                     "p" + std::to_string(number) + ".exr"};
    };
    const Words frames{"render", "a.lancer", "--frames", "1..6", "--resume", "-o", "f-%d.png"};
    const auto begin = std::chrono::steady_clock::now();
    for (int number = 1; number <= 3; ++number) ASSERT_EQ(place.run(part(number)).code, 0);
    const auto length = (std::chrono::steady_clock::now() - begin) / 3;
    ASSERT_EQ(place.run(frames).code, 0);
    const std::string sixth = place.read("f-6.png");
    constexpr int kills = 30;
    int hit = 0;
    for (int i = 0; i < kills; ++i) {
        const int number = i % 3 + 1;
        if (i % 4 != 0) fs::remove(place.path("p" + std::to_string(number) + ".exr"));
        for (int frame = 1; frame <= 6; ++frame)
            if (i % 3 != 0) fs::remove(place.path("f-" + std::to_string(frame) + ".png"));
        for (const Words& command : {part(number), frames}) {
            const pid_t run = place.start({}, command);
            std::this_thread::sleep_for(length * i / kills);
            kill(run, SIGKILL);
            hit += place.finish(run).code == 128 + SIGKILL ? 1 : 0;
        }
    }
    EXPECT_GT(hit, kills / 2);
    for (int number = 1; number <= 3; ++number) {
        const Finished finished = place.run(part(number));
        ASSERT_EQ(finished.code, 0);
        EXPECT_EQ(finished.err, "") << "something half was there";
    }
    EXPECT_EQ(place.run(frames).err, "");
    EXPECT_TRUE(place.read("f-6.png") == sixth);
    ASSERT_EQ(place.run({"join", "p1.exr", "p2.exr", "p3.exr", "-o", "out.png"}).code, 0);
    EXPECT_TRUE(place.read("out.png") == place.read("whole.png"));
}

}  // namespace
}  // namespace lancer::cli
