// The runner with programs that imitate POV-Ray: POV-Ray itself is not needed.
#include "reference/povray/runner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>

#include "base/sha256.h"
#include "base/sha256_blocks.h"
#include "model/diagnostic.h"
#include "model/io/png_file.h"
#include "model/io/temporary_file.h"
#include "reference/povray/cache.h"

namespace lancer::reference {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

/// An environment variable that the destructor restores.
class Variable {
  public:
    Variable(const char* name, const std::string& value) : name_(name) {
        if (const char* old = std::getenv(name)) old_ = old;
        ::setenv(name, value.c_str(), 1);
    }
    ~Variable() {
        if (old_)
            ::setenv(name_, old_->c_str(), 1);
        else
            ::unsetenv(name_);
    }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

  private:
    const char* name_;
    std::optional<std::string> old_;
};

class Runner : public testing::Test {
  protected:
    /// A shell script in place of POV-Ray.
    std::string program(const std::string& body) {
        const fs::path path = folder_.path() / "povray";
        std::ofstream(path) << "#!/bin/sh\n" << body << "\n";
        fs::permissions(path, fs::perms::owner_all);
        return path.string();
    }
    PovRay pretender(const std::string& body) { return {program(body), "3.7.0.test"}; }

    std::string message_of(const std::function<void()>& call) {
        try {
            call();
        } catch (const FileError& error) {
            return error.what();
        }
        return "no FileError";
    }
    std::string failure(const std::string& body, double limit = 20) {
        const PovRay povray = pretender(body);
        PovOptions options;
        options.time_limit = limit;
        return message_of([&] { run_povray(povray, job_, options); });
    }
    /// A script that puts a 2 x 1 picture where POV-Ray would, and counts its runs.
    std::string draws(double value, int bits = 16) {
        Image image(2, 1);
        image.data.assign(6, value);
        std::ofstream(folder_.path() / "drawn.png", std::ios::binary)
            << io::encode_png(image, {bits, true}, "drawn.png");
        return "echo run >> " + (folder_.path() / "runs").string() + "\ncp " +
               (folder_.path() / "drawn.png").string() + " scene.png";
    }
    std::size_t runs() const {
        std::ifstream file(folder_.path() / "runs");
        std::size_t count = 0;
        for (std::string line; std::getline(file, line);) ++count;
        return count;
    }

    io::TemporaryFolder folder_;
    PovJob job_{"ball", "#version 3.7;", {{"motif.png", "bytes"}}, 2, 1};
};

TEST_F(Runner, SaysWhereItLookedWhenThereIsNoPovRay) {
    const Variable none("LANCER_POVRAY", "");
    const Variable path("PATH", folder_.path().string());
    EXPECT_THAT(message_of([] { find_povray(); }),
                AllOf(HasSubstr("not found"), HasSubstr("LANCER_POVRAY"), HasSubstr("PATH")));
}

TEST_F(Runner, RefusesAVariableThatNamesNoProgram) {
    const Variable wrong("LANCER_POVRAY", "/nowhere/povray");
    EXPECT_EQ(message_of([] { find_povray(); }),
              "LANCER_POVRAY is set to '/nowhere/povray', which is not a program");
}

TEST_F(Runner, TakesTheVariableBeforeThePath) {
    const Variable named("LANCER_POVRAY", program("echo POV-Ray 3.7.0.99.test >&2"));
    EXPECT_EQ(find_povray().version, "3.7.0.99.test");
}

TEST_F(Runner, FindsThePathsFirst) {
    const std::string found = program("echo POV-Ray 3.7.0.98");
    const Variable none("LANCER_POVRAY", "");
    const Variable path("PATH", "/nowhere:" + folder_.path().string());
    EXPECT_EQ(find_povray().program, found);
}

TEST_F(Runner, RefusesAnotherVersion) {
    const Variable named("LANCER_POVRAY", program("echo POV-Ray 3.8.0-beta.2"));
    EXPECT_THAT(message_of([] { find_povray(); }), HasSubstr("is POV-Ray 3.8.0-beta.2, but"));
}

TEST_F(Runner, RefusesAProgramThatIsNoPovRay) {
    const Variable named("LANCER_POVRAY", program("echo something else"));
    EXPECT_THAT(message_of([] { find_povray(); }),
                AllOf(HasSubstr("does not say"), HasSubstr("something else")));
}

TEST_F(Runner, QuotesTheErrorsOfAPovRayThatFails) {
    const std::string message = failure(
        "echo 'File scene.pov line 3: Parse Error: No matching }'\necho ' in pigment'\n"
        "echo Rendering\nexit 1");
    EXPECT_EQ(message,
              "POV-Ray failed on 'ball' (exit code 1):\n"
              "    File scene.pov line 3: Parse Error: No matching } in pigment");
}

TEST_F(Runner, QuotesTheLastWordsWhenNothingLooksLikeAnError) {
    EXPECT_THAT(failure("echo one\necho two\necho three\necho four\nkill -9 $$"),
                AllOf(HasSubstr("exit code 137"), HasSubstr("two\n    three\n    four"),
                      testing::Not(HasSubstr("one"))));
}

TEST_F(Runner, StopsAPovRayThatHangsWithAllItStarted) {
    const std::string alive = (folder_.path() / "alive").string();
    const std::string body = "(sleep 2; touch " + alive + ") &\nsleep 60";
    EXPECT_EQ(failure(body, 0.2), "POV-Ray did not finish 'ball' within 0.2 s and was stopped");
    const auto start = std::chrono::steady_clock::now();
    while (std::chrono::steady_clock::now() - start < std::chrono::milliseconds(2500) &&
           !fs::exists(alive))
        ::usleep(50000);
    EXPECT_FALSE(fs::exists(alive));
}

TEST_F(Runner, SaysThatNothingWasWritten) {
    EXPECT_THAT(failure("exit 0"), HasSubstr("wrote no picture of 'ball'"));
}

TEST_F(Runner, RefusesAPictureThatIsNoPng) {
    EXPECT_THAT(failure("echo rubbish > scene.png"),
                HasSubstr("cannot read 'POV-Ray's picture of ball'"));
}

TEST_F(Runner, RefusesAPictureOfAnotherKind) {
    EXPECT_THAT(failure(draws(0.5, 8)), HasSubstr("3 channels of 8 bits, not 2 x 1 with 3 of 16"));
}

TEST_F(Runner, RunsInAFreshFolderWithTheSceneAndItsAssets) {
    const std::string seen = (folder_.path() / "seen").string();
    const PovRay povray =
        pretender(draws(0) + "\n{ ls; cat motif.png; echo; echo $HOME; pwd; echo $@; } > " + seen);
    const PovPicture picture = run_povray(povray, job_);
    std::ifstream file(seen);
    const std::string all{std::istreambuf_iterator<char>(file), {}};
    EXPECT_THAT(all,
                AllOf(HasSubstr("scene.pov"), HasSubstr("bytes"),
                      HasSubstr("+Iscene.pov +Oscene.png +W2 +H1 +FN16 File_Gamma=1.0 -D -A")));
    const std::size_t home = all.find("/lancer-");
    ASSERT_NE(home, std::string::npos);
    const std::string folder =
        all.substr(all.rfind('\n', home) + 1, all.find('\n', home) - all.rfind('\n', home) - 1);
    EXPECT_FALSE(fs::exists(folder)) << "it is removed: " << folder;
}

TEST_F(Runner, GivesTheIntegersAsLinearLight) {
    const PovPicture picture = run_povray(pretender(draws(0.2)), job_);
    ASSERT_EQ(picture.image.data.size(), 6u);
    EXPECT_DOUBLE_EQ(picture.image.data[0], 0.2);
    EXPECT_FALSE(picture.from_cache);
}

TEST_F(Runner, TakesTheSecondPictureFromTheCache) {
    const PovRay povray = pretender(draws(0.2));
    PovOptions options;
    options.cache = (folder_.path() / "cache").string();
    const PovPicture first = run_povray(povray, job_, options);
    const PovPicture second = run_povray(povray, job_, options);
    EXPECT_EQ(runs(), 1u);
    EXPECT_TRUE(second.from_cache);
    EXPECT_EQ(first.image.data, second.image.data);
    EXPECT_EQ(first.seconds, second.seconds);
}

TEST_F(Runner, RendersAgainWhenAnythingThatMattersChanges) {
    const PovRay povray = pretender("");
    const std::string key = cache_key(povray, job_);
    PovJob other = job_;
    other.text += " ";
    EXPECT_NE(cache_key(povray, other), key);
    other = job_;
    other.assets[0].bytes[0] = 'B';
    EXPECT_NE(cache_key(povray, other), key);
    other = job_;
    other.assets[0].name = "motif.pn";
    other.assets[0].bytes = "gbytes";
    EXPECT_NE(cache_key(povray, other), key);
    other = job_;
    other.height = 2;
    EXPECT_NE(cache_key(povray, other), key);
    EXPECT_NE(cache_key({povray.program, "3.7.0.other"}, job_), key);
    other = job_;
    other.name = "only a name";
    EXPECT_EQ(cache_key(povray, other), key);
}

TEST_F(Runner, TreatsADamagedEntryAsNone) {
    const PovRay povray = pretender(draws(0.2));
    PovOptions options;
    options.cache = (folder_.path() / "cache").string();
    run_povray(povray, job_, options);
    const fs::path entry = fs::path(options.cache) / "povray" / cache_key(povray, job_);
    std::string bytes;
    {
        std::ifstream file(entry, std::ios::binary);
        bytes.assign(std::istreambuf_iterator<char>(file), {});
    }
    ASSERT_GT(bytes.size(), 100u);
    std::size_t expected = 1;
    for (const std::size_t size :
         {std::size_t(0), std::size_t(30), bytes.size() - 1, bytes.size()}) {
        std::string damaged = bytes.substr(0, size);
        if (size == bytes.size()) damaged[size - 20] ^= 1;
        std::ofstream(entry, std::ios::binary) << damaged;
        EXPECT_FALSE(run_povray(povray, job_, options).from_cache) << size;
        EXPECT_EQ(runs(), ++expected);
    }
}

TEST_F(Runner, RendersWithoutACacheThatCannotBeWritten) {
    const PovRay povray = pretender(draws(0.2));
    std::ofstream(folder_.path() / "file") << "in the way";
    PovOptions options;
    options.cache = (folder_.path() / "file").string();
    EXPECT_DOUBLE_EQ(run_povray(povray, job_, options).image.data[0], 0.2);
}

TEST_F(Runner, RunsManyJobsAndKeepsTheirOrder) {
    const PovRay povray = pretender("case $(cat scene.pov) in *bad*) exit 3;; esac\n" + draws(0.2));
    std::vector<PovJob> jobs(7, job_);
    jobs[3].text = "bad";
    jobs[3].name = "third";
    std::vector<std::size_t> done;
    const std::vector<PovOutcome> outcomes =
        run_povray_jobs(povray, jobs, {}, 3, [&](std::size_t i) { done.push_back(i); });
    ASSERT_EQ(outcomes.size(), 7u);
    EXPECT_THAT(done, testing::UnorderedElementsAre(0, 1, 2, 3, 4, 5, 6));
    for (std::size_t i = 0; i < outcomes.size(); ++i)
        EXPECT_EQ(outcomes[i].picture.has_value(), i != 3) << outcomes[i].failure;
    EXPECT_THAT(outcomes[3].failure, HasSubstr("'third' (exit code 3)"));
}

TEST(CacheFolder, IsTheVariableElseTheDesktopsElseHome) {
    const Variable home("HOME", "/home/x");
    const Variable base("XDG_CACHE_HOME", "/base");
    const Variable own("LANCER_CACHE", "/own");
    EXPECT_EQ(cache_folder(), "/own");
    ::setenv("LANCER_CACHE", "", 1);
    EXPECT_EQ(cache_folder(), "/base/lancer");
    ::setenv("XDG_CACHE_HOME", "", 1);
    EXPECT_EQ(cache_folder(), "/home/x/.cache/lancer");
    ::setenv("HOME", "", 1);
    EXPECT_EQ(cache_folder(), "");
}

// Examples of FIPS 180-4 as published by NIST.
TEST(Sha256, IsTheSameByInstructionsOfTheProcessor) {
    if (!has_sha_instructions()) GTEST_SKIP() << "this processor has none";
    std::mt19937 random(1);
    std::string blocks(5 * 64, '\0');
    for (int round = 0; round < 100; ++round) {
        for (char& c : blocks) c = static_cast<char>(random());
        Sha256State plain{1, 2, 3, 4, 5, 6, 7, 8};
        Sha256State fast = plain;
        absorb_plainly(plain, blocks.data(), 5);
        absorb_by_instructions(fast, blocks.data(), 5);
        ASSERT_EQ(plain, fast);
        absorb(plain, blocks.data() + 3, 4);
        absorb_plainly(fast, blocks.data() + 3, 4);
        ASSERT_EQ(plain, fast);
    }
}

TEST(Sha256, GivesThePublishedDigests) {
    EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
              "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    EXPECT_EQ(sha256(std::string(1000000, 'a')),
              "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

}  // namespace
}  // namespace lancer::reference
