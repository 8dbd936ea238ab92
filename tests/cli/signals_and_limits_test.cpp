// Events that end a run from outside: signals, and limits of the system.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <nlohmann/json.hpp>

#include <cerrno>
#include <chrono>
#include <new>
#include <stdexcept>
#include <system_error>
#include <thread>

#include "cli/guarded.h"
#include "cli/memory_bound.h"
#include "model/diagnostic.h"
#include "model/io/system_error.h"
#include "tests/cli/run_lancer.h"

namespace lancer::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::vector<std::string> long_run{"render", "a.lancer", "--samples",
                                        "100",    "--size",   "640x480"};
const std::vector<std::string> short_run{"render", "a.lancer", "--samples", "30"};

class FromOutside : public testing::Test {
  protected:
    FromOutside() { place_.write("a.lancer", small_scene()); }
    /// Starts, waits until the program is at work, and sends the signal.
    Finished interrupted(const Surroundings& surroundings, const std::vector<std::string>& command,
                         int signal_number) const {
        const pid_t run = place_.start(surroundings, command);
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        kill(run, signal_number);
        return place_.finish(run);
    }
    Workplace place_;
};

TEST_F(FromOutside, ASignalEndsARunWithItsCodeAndLeavesNothing) {
    EXPECT_EQ(interrupted({}, long_run, SIGINT).code, 130);
    EXPECT_EQ(interrupted({}, long_run, SIGTERM).code, 143);
    EXPECT_THAT(place_.files(), ElementsAre("a.lancer"));
}

TEST_F(FromOutside, ASignalThatTheCallerIgnoresIsIgnored) {
    const Surroundings nohup{.ignores_signals = true};
    EXPECT_EQ(interrupted(nohup, short_run, SIGINT).code, 0);
    EXPECT_EQ(interrupted(nohup, short_run, SIGTERM).code, 0);
}

TEST_F(FromOutside, AThreadThatCannotBeStartedIsAnErrorOfTheSystem) {
    // 128 MB of stack for each thread, of 300 MB in all.
    const Finished finished =
        place_.run_in({.limits = "-v 300000"}, {"render", "a.lancer", "--threads", "3"});
    EXPECT_EQ(finished.code, 4) << finished.err;
    EXPECT_THAT(finished.err, HasSubstr("cannot start a thread"));
    EXPECT_THAT(place_.files(), ElementsAre("a.lancer"));
}

TEST_F(FromOutside, MemoryThatRunsOutIsAnErrorOfTheSystem) {
    place_.write("a.lancer",
                 small_scene() + "for i in 0..2000000 { sphere { center [i, 0, 0] radius 1 } }");
    const Finished finished =
        place_.run_in({.limits = "-v 300000"}, {"render", "a.lancer", "--threads", "1"});
    EXPECT_EQ(finished.code, 4) << finished.err;
    EXPECT_THAT(finished.err, HasSubstr("not enough memory"));
    EXPECT_THAT(place_.files(), ElementsAre("a.lancer"));
}

TEST_F(FromOutside, APictureAboveTheLimitOfTheShellIsRefusedBeforeTheWork) {
    const Finished finished = place_.run_in(
        {.limits = "-v 1000000"}, {"render", "a.lancer", "--size", "9000x9000", "--threads", "1"});
    EXPECT_EQ(finished.code, 2) << finished.err;
    EXPECT_THAT(finished.err, HasSubstr("a picture of 9000x9000 pixels needs"));
}

TEST_F(FromOutside, AFileAboveTheLimitOfTheShellIsAnErrorAndLeavesNothing) {
    const Finished finished = place_.run_in({.limits = "-f 1"}, {"render", "a.lancer"});
    EXPECT_EQ(finished.code, 4) << finished.err;
    EXPECT_THAT(finished.err, HasSubstr("cannot write 'a.png': File too large"));
    EXPECT_THAT(place_.files(), ElementsAre("a.lancer"));
}

TEST(MemoryBound, IsTheLeastThatIsSaid) {
    const Workplace place;
    const std::uint64_t machine = available_memory({});
    EXPECT_GT(machine, std::uint64_t(1) << 28);
    place.write("none", "max\n");
    place.write("small", "123456789\n");
    place.write("huge", "9223372036854771712\n");
    const auto bound = [&](std::vector<std::string> names) {
        for (std::string& name : names) name = place.path(name);
        return available_memory(names);
    };
    EXPECT_EQ(bound({"none", "huge", "missing"}), machine);
    EXPECT_EQ(bound({"none", "small"}), 123456789u);
    EXPECT_EQ(bound({"small", "huge"}), 123456789u);
}

/// The most memory that a run took, in MB.
double peak_of(const Workplace& place, std::vector<std::string> command) {
    command.insert(command.end(), {"-q", "--threads", "1", "--stats", "stats.json"});
    const Finished finished = place.run_in({}, command);
    EXPECT_EQ(finished.code, 0) << finished.err;
    return nlohmann::json::parse(place.read("stats.json")).at("peak_memory_bytes").get<double>() /
           1e6;
}

TEST(MemoryBound, TheLastPictureIsDrawnWithoutTheSyntaxOfItsScript) {
    const Workplace place;
    std::string script = small_scene();
    for (int i = 0; i < 100'000; ++i)
        script += "sphere { center [" + std::to_string(i) + ", 0, 0] radius 1 }\n";
    place.write("a.lancer", script);
    const double one = peak_of(place, {"render", "a.lancer"});
    // While the first frame is drawn, the syntax is kept for the second.
    const double two = peak_of(place, {"render", "a.lancer", "--frames", "0..1"});
    EXPECT_LT(one + 20, two);
}

TEST(Guarded, TellsEachKindOfFailureByItsCode) {
    Session session;
    const auto code = [&session](const std::function<void()>& work) {
        testing::internal::CaptureStderr();
        const ExitCode result = guarded(session, [&work] {
            work();
            return ExitCode::differs;
        });
        return std::pair(result, testing::internal::GetCapturedStderr());
    };
    EXPECT_EQ(code([] {}), std::pair(ExitCode::differs, std::string()));
    EXPECT_EQ(code([] { throw UsageError("x"); }).first, ExitCode::usage);
    EXPECT_EQ(code([] { throw SceneError({}, "x"); }).first, ExitCode::scene);
    EXPECT_EQ(code([] { throw SceneRejected(ExitCode::scene); }).first, ExitCode::scene);
    EXPECT_EQ(code([] { throw FileError("x"); }).first, ExitCode::files);
    EXPECT_EQ(code([] { throw std::bad_alloc(); }).first, ExitCode::files);
    EXPECT_EQ(code([] { throw std::system_error(EAGAIN, std::generic_category()); }).first,
              ExitCode::files);
    const auto system = [&code](int number) {
        return code([number] { throw io::system_error("cannot read", "x", number); }).first;
    };
    EXPECT_EQ(system(ESTALE), ExitCode::try_again);
    EXPECT_EQ(system(ENOSPC), ExitCode::files);
    const auto bug = code([] { throw std::out_of_range("map::at"); });
    EXPECT_EQ(bug.first, ExitCode::bug);
    EXPECT_THAT(bug.second, HasSubstr("this is a bug in lancer: map::at"));
    EXPECT_EQ(code([] { throw 1; }).first, ExitCode::bug);
}

}  // namespace
}  // namespace lancer::cli
