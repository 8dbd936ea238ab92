#include "model/io/file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>

#include "tests/io/scratch_folder.h"

namespace lancer::io {
namespace {

using testing::HasSubstr;

TEST(ReadFile, ReturnsAllBytes) {
    const ScratchFolder folder;
    std::string bytes = "a\0b\r\n\xFF";
    bytes += std::string(100000, 'x');
    put(folder / "f", bytes);
    EXPECT_EQ(read_file(folder / "f"), bytes);
    put(folder / "empty", "");
    EXPECT_EQ(read_file(folder / "empty"), "");
}

TEST(ReadFile, SaysWhyItCannot) {
    const ScratchFolder folder;
    EXPECT_THAT(file_error([&] { read_file(folder / "no"); }),
                testing::AllOf(HasSubstr("no'"), HasSubstr("No such file")));
    EXPECT_THAT(file_error([&] { read_file(folder / ""); }), HasSubstr("directory"));
    EXPECT_THAT(file_error([&] { read_file(""); }), HasSubstr("No such file"));
}

TEST(ReadFile, KeepsToTheLimit) {
    const ScratchFolder folder;
    put(folder / "f", "12345");
    EXPECT_EQ(read_file(folder / "f", 5), "12345");
    EXPECT_THAT(file_error([&] { read_file(folder / "f", 4); }), HasSubstr("too large"));
    EXPECT_THAT(file_error([&] { read_file("/dev/zero", 1000); }), HasSubstr("too large"));
}

TEST(WriteFile, ReplacesInOneStepAndLeavesNothingElse) {
    const ScratchFolder folder;
    put(folder / "f", "old");
    write_file(folder / "f", "new");
    EXPECT_EQ(contents(folder / "f"), "new");
    write_file(folder / "g", std::string(1 << 20, 'g'));
    EXPECT_EQ(contents(folder / "g").size(), std::size_t{1} << 20);
    EXPECT_EQ(folder.entries(), 2u);
}

TEST(WriteFile, GivesTheRightsOfAnOrdinaryNewFile) {
    const ScratchFolder folder;
    const mode_t before = umask(027);
    write_file(folder / "f", "x");
    umask(before);
    struct stat status {};
    ASSERT_EQ(stat((folder / "f").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777, 0640u);
}

TEST(WriteAtomically, KeepsTheOldFileWhenWritingFails) {
    const ScratchFolder folder;
    put(folder / "f.png", "old");
    EXPECT_THROW(write_atomically(folder / "f.png",
                                  [](const std::string& temporary) {
                                      put(temporary, "half");
                                      throw std::runtime_error("broken");
                                  }),
                 std::runtime_error);
    EXPECT_EQ(contents(folder / "f.png"), "old");
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(WriteAtomically, ShowsNothingUnderTheNameBeforeTheEnd) {
    const ScratchFolder folder;
    write_atomically(folder / "a.exr", [&](const std::string& temporary) {
        EXPECT_FALSE(std::filesystem::exists(folder / "a.exr"));
        EXPECT_NE(temporary, folder / "a.exr");
        put(temporary, "x");
    });
    EXPECT_EQ(contents(folder / "a.exr"), "x");
}

TEST(WriteAtomically, ALongNameIsNoProblem) {
    const ScratchFolder folder;
    const std::string name = folder / (std::string(251, 'n') + ".png");
    write_file(name, "x");
    EXPECT_EQ(contents(name), "x");
}

TEST(WriteFile, SaysWhyItCannot) {
    const ScratchFolder folder;
    EXPECT_THAT(file_error([&] { write_file(folder / "no/f", "x"); }),
                testing::AllOf(HasSubstr("no/f'"), HasSubstr("No such file")));
    std::filesystem::create_directory(folder / "d");
    for (const char* name : {"d", "d/", "e/"}) {
        EXPECT_THAT(file_error([&] { write_file(folder / name, "x"); }), HasSubstr("directory"));
        EXPECT_THAT(file_error([&] { write_atomically(folder / name, [](const auto&) {}); }),
                    HasSubstr("directory"));
    }
    EXPECT_THAT(file_error([&] { write_file("", "x"); }), HasSubstr("No such file"));
    put(folder / "f", "");
    EXPECT_THAT(file_error([&] { write_file(folder / "f/g", "x"); }), HasSubstr("Not a dir"));
    EXPECT_EQ(folder.entries(), 2u);
}

TEST(WriteFile, WritesThroughALink) {
    const ScratchFolder folder;
    std::filesystem::create_directory(folder / "d");
    std::filesystem::create_symlink("d/target", folder / "link");
    write_file(folder / "link", "first");  // the link leads nowhere yet
    EXPECT_EQ(contents(folder / "d/target"), "first");
    write_file(folder / "link", "second");
    EXPECT_EQ(contents(folder / "d/target"), "second");
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
    std::filesystem::create_symlink("loop", folder / "loop");
    EXPECT_THROW(write_file(folder / "loop", "x"), FileError);
}

TEST(WriteFile, WritesIntoDevicesAndPipesInsteadOfReplacingThem) {
    const ScratchFolder folder;
    write_file("/dev/null", "x");
    write_atomically("/dev/null", [](const std::string& temporary) { put(temporary, "x"); });
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
    ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
    FILE* reader = fopen((folder / "pipe").c_str(), "r+");
    ASSERT_NE(reader, nullptr);
    write_file(folder / "pipe", "abc");
    char text[4] = {};
    EXPECT_EQ(fread(text, 1, 3, reader), 3u);
    EXPECT_STREQ(text, "abc");
    fclose(reader);
    EXPECT_TRUE(std::filesystem::is_fifo(folder / "pipe"));
}

TEST(WriteFile, AnOrdinaryFileBelowDevIsReplacedLikeAnyOther) {
    if (!std::filesystem::is_directory("/dev/shm")) GTEST_SKIP() << "no /dev/shm";
    const std::string path = "/dev/shm/lancer-file-test-" + std::to_string(getpid());
    write_file(path, "a longer text");
    write_file(path, "short");
    EXPECT_EQ(read_file(path), "short");
    EXPECT_FALSE(is_stream(path));
    std::filesystem::remove(path);
    EXPECT_TRUE(is_stream("/dev/stdout"));
    EXPECT_TRUE(is_stream("/dev/null"));
    EXPECT_FALSE(is_stream("/dev"));
}

}  // namespace
}  // namespace lancer::io
