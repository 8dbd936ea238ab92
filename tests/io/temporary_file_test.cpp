#include "model/io/temporary_file.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>

#include "model/io/leftovers.h"
#include "model/io/temporary_registry.h"
#include "tests/io/scratch_folder.h"

namespace lancer::io {
namespace {

using Naming = TemporaryFile::Naming;

/// Whether the file system of the tests supports files without names.
bool has_unnamed_files(const ScratchFolder& folder) {
    const int file = open((folder / "").c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
    if (file >= 0) close(file);
    return file >= 0;
}

/// Runs `work` in a process of its own that is then killed, as by kill -9.
template <class Work>
void in_killed_process(Work work) {
    const pid_t child = fork();
    if (child == 0) {
        work();
        kill(getpid(), SIGKILL);
    }
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status));
}

class BothNamings : public testing::TestWithParam<Naming> {
  protected:
    ScratchFolder folder_;
};

TEST_P(BothNamings, AFileIsThereWhenItIsKeptAndNotBefore) {
    for (int round = 0; round < 2; ++round) {  // the second replaces what the first made
        TemporaryFile file(folder_ / "", ".png", "a.png", GetParam());
        put(file.name(), "round " + std::to_string(round));
        EXPECT_EQ(std::filesystem::exists(folder_ / "a.png"), round == 1);
        file.keep_as(folder_ / "a.png");
        EXPECT_EQ(contents(folder_ / "a.png"), "round " + std::to_string(round));
        EXPECT_EQ(folder_.entries(), 1u);
    }
    EXPECT_EQ(folder_.entries(), 1u);
}

TEST_P(BothNamings, AFileThatIsNotKeptIsGone) {
    put(TemporaryFile(folder_ / "", "", "a", GetParam()).name(), "text");
    EXPECT_EQ(folder_.entries(), 0u);
}

TEST_P(BothNamings, AFileThatCannotTakeItsPlaceIsGone) {
    std::filesystem::create_directory(folder_ / "taken");
    {
        TemporaryFile file(folder_ / "", "", "taken", GetParam());
        EXPECT_THAT(file_error([&] { file.keep_as(folder_ / "taken"); }),
                    testing::HasSubstr("taken"));
    }
    EXPECT_EQ(folder_.entries(), 1u);
}

TEST_P(BothNamings, AnotherProcessCanOpenIt) {
    const TemporaryFile file(folder_ / "", "", "a", GetParam());
    const pid_t child = fork();
    if (child == 0) {
        close(file.descriptor());  // as in a program that was started
        put(file.name(), "from the child");
        _exit(0);
    }
    waitpid(child, nullptr, 0);
    EXPECT_EQ(contents(file.name()), "from the child");
}

INSTANTIATE_TEST_SUITE_P(TemporaryFile, BothNamings,
                         testing::Values(Naming::if_needed, Naming::always));

TEST(TemporaryFile, AKilledProcessLeavesNoUnnamedFile) {
    const ScratchFolder folder;
    if (!has_unnamed_files(folder)) GTEST_SKIP() << "no O_TMPFILE in the temporary folder";
    in_killed_process([&] {
        static const TemporaryFile file(folder / "", "", "a");
        put(file.name(), "half");
    });
    EXPECT_EQ(folder.entries(), 0u);
}

TEST(TemporaryFile, TheNextRunRemovesWhatAKilledOneLeft) {
    const ScratchFolder folder;
    in_killed_process([&] {
        static const TemporaryFile file(folder / "", ".png", "a", Naming::always);
        put(file.name(), "half");
    });
    EXPECT_EQ(folder.entries(), 1u);
    remove_leftover_files(folder / "");
    EXPECT_EQ(folder.entries(), 0u);
}

TEST(TemporaryFile, NobodyRemovesWhatIsInUseOrHasAnotherName) {
    const ScratchFolder folder;
    const TemporaryFile used(folder / "", ".png", "a", Naming::always);
    for (const char* name : {".lancer-1-2-3", ".lancer-1-2-0123456g", ".lancer-a-2-01234567",
                             ".lancer-notes", "lancer-1-2-01234567", ".lancer-1-2-01234567x"})
        put(folder / name, "the user's");
    std::filesystem::create_directory(folder / ".lancer-1-2-01234567");
    std::filesystem::create_symlink(".lancer-notes", folder / ".lancer-1-2-11234567");
    put(folder / ".lancer-1-2-21234567.png", "left behind");
    EXPECT_EQ(folder.entries(), 10u);
    // another name for the folder, which was not examined before
    remove_leftover_files(folder / "./");
    EXPECT_EQ(folder.entries(), 9u);
    EXPECT_FALSE(std::filesystem::exists(folder / ".lancer-1-2-21234567.png"));
}

TEST(TemporaryFile, IsRemovedWhenASignalHandlerAsks) {
    const ScratchFolder folder;
    const TemporaryFile a(folder / "", "", "a", Naming::always);
    EXPECT_EQ(folder.entries(), 1u);
    {
        TemporaryFile kept(folder / "", "", "b", Naming::always);
        kept.keep_as(folder / "b");
    }
    remove_temporary_files();
    EXPECT_EQ(folder.entries(), 1u);
    EXPECT_TRUE(std::filesystem::exists(folder / "b"));
}

TEST(TemporaryFolder, TheNextRunRemovesWhatAKilledOneLeft) {
    const ScratchFolder folder;
    setenv("TMPDIR", (folder / "").c_str(), 1);
    in_killed_process([&] {
        static const TemporaryFolder used;
        put(used.path() / "half-a-picture", "half");
    });
    EXPECT_EQ(folder.entries(), 1u);
    std::filesystem::create_directory(folder / "lancer-temporary-files-of-mine");
    {
        const TemporaryFolder mine;
        EXPECT_EQ(folder.entries(), 2u) << "its own and the user's";
        remove_leftover_folders(folder / "./");
        EXPECT_TRUE(std::filesystem::exists(mine.path()));
    }
    unsetenv("TMPDIR");
    EXPECT_EQ(folder.entries(), 1u);
    EXPECT_TRUE(std::filesystem::exists(folder / "lancer-temporary-files-of-mine"));
}

}  // namespace
}  // namespace lancer::io
