// A run that is killed leaves nothing behind, and no half file.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/ptrace.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <iterator>
#include <thread>

#include "tests/cli/run_lancer.h"

namespace lancer::cli {
namespace {

namespace fs = std::filesystem;
using testing::AnyOf;
using testing::ElementsAre;

/// Runs `render a.lancer -o OUTPUT` up to a number of stops, two for each system call of its main
/// thread, and kills it there. Returns how many stops there were.
int render_until(const Workplace& place, const char* output, int most_stops) {
    const pid_t child = fork();
    if (child == 0) {
        const int nothing = open("/dev/null", O_RDWR);
        dup2(nothing, 1);
        dup2(nothing, 2);
        if (chdir(place.path("").c_str()) == 0 && ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) == 0)
            execl(lancer_program(), "lancer", "render", "a.lancer", "-o", output, "--threads", "1",
                  nullptr);
        _exit(127);
    }
    int status = 0;
    waitpid(child, &status, 0);
    int stops = 0;
    while (WIFSTOPPED(status) && stops < most_stops) {
        // A stop that is not for a system call is a signal for the program.
        const int sent = WSTOPSIG(status) == SIGTRAP ? 0 : WSTOPSIG(status);
        if (ptrace(PTRACE_SYSCALL, child, nullptr, sent) != 0) break;
        waitpid(child, &status, 0);
        ++stops;
    }
    if (WIFSTOPPED(status)) {
        kill(child, SIGKILL);
        waitpid(child, &status, 0);
    }
    return stops;
}

bool has_unnamed_files(const Workplace& place) {
    const int file = open(place.path("").c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
    if (file >= 0) close(file);
    return file >= 0;
}

/// The last steps of a run, one by one: all steps on the picture's file.
constexpr int steps_tried = 90;
constexpr int endless = 1'000'000;

TEST(Killed, AtAnyOfItsLastStepsARunHasWrittenAllOrNothing) {
    const Workplace place;
    place.write("a.lancer", small_scene());
    const int stops = render_until(place, "whole.png", endless);
    if (stops < steps_tried) GTEST_SKIP() << "this machine lets no process watch another";
    const std::string whole = place.read("whole.png");
    ASSERT_FALSE(whole.empty());
    fs::remove(place.path("whole.png"));
    const bool unnamed = has_unnamed_files(place);

    int written = 0;
    for (int at = stops - steps_tried; at < stops; ++at) {
        render_until(place, "new.png", at);
        if (place.exists("new.png")) {
            ++written;
            EXPECT_EQ(place.read("new.png"), whole) << "half a picture after " << at;
            fs::remove(place.path("new.png"));
        }
        if (unnamed) {
            EXPECT_THAT(place.files(), ElementsAre("a.lancer")) << at;
        }
    }
    EXPECT_GT(written, 0) << "the picture was never reached";
    EXPECT_LT(written, steps_tried) << "the steps begin too late";
}

TEST(Killed, AFileThatIsReplacedIsTheOldOrTheNewOne) {
    const Workplace place;
    place.write("a.lancer", small_scene());
    const int stops = render_until(place, "a.png", endless);
    if (stops < steps_tried) GTEST_SKIP() << "this machine lets no process watch another";
    const std::string whole = place.read("a.png");
    for (int at = stops - steps_tried; at < stops; ++at) {
        place.write("a.png", "old");
        render_until(place, "a.png", at);
        EXPECT_THAT(place.read("a.png"), AnyOf("old", whole)) << at;
    }
    // Replacing a file needs a temporary name; the next run removes the file if it remained.
    render_until(place, "a.png", endless);
    EXPECT_THAT(place.files(), ElementsAre("a.lancer", "a.png"));
}

TEST(Killed, AtAnyMomentWithManyThreads) {
    const Workplace place;
    place.write("a.lancer", small_scene());
    const std::vector<std::string> command{"render", "a.lancer", "-o",        "a.exr",
                                           "--size", "160x120",  "--threads", "4"};
    const auto begin = std::chrono::steady_clock::now();
    ASSERT_EQ(place.run(command).code, 0);
    const auto length = std::chrono::steady_clock::now() - begin;
    const std::string whole = place.read("a.exr");
    constexpr int kills = 40;
    int hit = 0;
    for (int i = 0; i < kills; ++i) {
        const pid_t run = place.start({}, command);
        std::this_thread::sleep_for(length * i / kills);
        kill(run, SIGKILL);
        hit += place.finish(run).code == 128 + SIGKILL ? 1 : 0;
        EXPECT_EQ(place.read("a.exr"), whole);
    }
    EXPECT_GT(hit, 0);
    ASSERT_EQ(place.run(command).code, 0);
    EXPECT_THAT(place.files(), ElementsAre("a.exr", "a.lancer"));
}

TEST(Killed, AFolderForPovRayIsRemovedByTheNextRun) {
    const Workplace place;
    place.write("a.lancer", small_scene());
    place.write("povray",
                "#!/bin/sh\n[ \"$1\" = --version ] && echo 'POV-Ray 3.7.0.10' && exit\n"
                "touch half-a-picture; kill -KILL $PPID; exec sleep 20\n");
    fs::permissions(place.path("povray"), fs::perms::owner_all);
    fs::create_directory(place.path("tmp"));
    const Surroundings surroundings{
        .variables = {"LANCER_POVRAY=" + place.path("povray"), "TMPDIR=" + place.path("tmp")}};
    const auto folders = [&] {
        return std::distance(fs::directory_iterator(place.path("tmp")), fs::directory_iterator());
    };
    EXPECT_EQ(place.run_in(surroundings, {"validate", "--no-cache", "a.lancer"}).code, 137);
    EXPECT_EQ(folders(), 1);
    place.write("povray", "#!/bin/sh\nexit 1\n");
    EXPECT_EQ(place.run_in(surroundings, {"validate", "--no-cache", "a.lancer"}).code, 4);
    EXPECT_EQ(folders(), 0);
}

}  // namespace
}  // namespace lancer::cli
