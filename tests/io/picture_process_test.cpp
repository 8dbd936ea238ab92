// The process that works on pictures, with a module that misbehaves in place of the real one.
#include "model/io/picture_process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <thread>
#include <vector>

#include "model/io/image_file.h"
#include "model/io/stored_image.h"
#include "tests/io/scratch_folder.h"

namespace lancer::io {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

/// A program and a misbehaving module beside it, as in an installation.
class PictureProcess : public testing::Test {
  protected:
    PictureProcess() {
        fs::create_directories(folder_ / "bin");
        fs::create_directories(folder_ / "lib");
        fs::copy_file(LANCER_BINARY_DIR "/bin/lancer", folder_ / "bin/lancer");
        fs::copy_file(LANCER_BROKEN_MODULE, folder_ / "lib/lancer_images.so");
        set_picture_program(folder_ / "bin/lancer");
    }
    ~PictureProcess() override {
        set_picture_limits({});
        set_picture_program("");
    }

    Image read(const std::string& what) const {
        put(folder_ / "a.hdr", "#?RADIANCE\n" + what);
        return read_image(folder_ / "a.hdr", ColorSpace::linear);
    }
    std::string problem(const std::string& what) const {
        return file_error([&] { read(what); });
    }
    void expect_picture() const { EXPECT_THAT(read("picture").data, ElementsAre(0, 0.2, 0.4, 1)); }

    ScratchFolder folder_;
};

TEST_F(PictureProcess, ThatCrashesIsAnErrorAndTheNextPictureIsRead) {
    expect_picture();
    EXPECT_THAT(problem("abort"), HasSubstr("a.hdr': the library that reads it crashed (SIGABRT)"));
    EXPECT_THAT(problem("segv"), HasSubstr("SIGSEGV"));
    EXPECT_THAT(problem("fpe"), HasSubstr("SIGFPE"));
    EXPECT_THAT(problem("throw"), HasSubstr("a.hdr"));
    EXPECT_THAT(problem("exit"), HasSubstr("no picture"));
    EXPECT_THAT(problem("exit 3"), HasSubstr("failed"));
    expect_picture();
    EXPECT_THAT(file_error([&] { write_image(folder_ / "b.tif", Image(2, 2), {}); }),
                HasSubstr("b.tif': the library that writes it crashed (SIGABRT)"));
    EXPECT_FALSE(fs::exists(folder_ / "b.tif"));
}

TEST_F(PictureProcess, IsBoundedInTimeAndMemory) {
    set_picture_limits({64, 1});
    EXPECT_THAT(problem("spin"),
                HasSubstr("longer than the allowed 1 s (--limit-picture-seconds)"));
    EXPECT_THAT(problem("sleep"), HasSubstr("longer than the allowed 1 s"));
#ifndef __SANITIZE_ADDRESS__  // the shadow memory exceeds any limit
    EXPECT_THAT(problem("memory"), HasSubstr("more memory than the allowed 64 MiB"));
#endif
    set_picture_limits({32, 10});
    EXPECT_THAT(problem("pixels"), HasSubstr("more memory than the allowed 32 MiB"));
    set_picture_limits({128, 10});
    EXPECT_EQ(read("pixels").width, 8192);
}

TEST_F(PictureProcess, MayUseNothingButItsTwoDescriptorsAndThreads) {
    put(folder_ / "kept", "");
    EXPECT_THAT(problem("open"), HasSubstr("forbidden"));
    EXPECT_THAT(problem("create"), HasSubstr("forbidden"));
    EXPECT_THAT(problem("unlink"), HasSubstr("forbidden"));
    EXPECT_THAT(problem("socket"), HasSubstr("forbidden"));
    EXPECT_THAT(problem("fork"), HasSubstr("forbidden"));
    EXPECT_THAT(problem("kill"), HasSubstr("forbidden"));
    EXPECT_THAT(problem("thread"), HasSubstr("allowed"));
    const int open_here = dup(STDIN_FILENO);  // inherited by none
    EXPECT_THAT(problem("descriptors"), HasSubstr("a.hdr': 2"));
    close(open_here);
}

TEST_F(PictureProcess, IsNotBelievedWhenItGivesLessThanItPromised) {
    EXPECT_THAT(problem("few"), HasSubstr("no picture"));
    EXPECT_THAT(problem("nothing"), HasSubstr("a.hdr"));
}

TEST_F(PictureProcess, ServesThreadsOneAfterTheOther) {
    put(folder_ / "b.hdr", "#?RADIANCE\npicture");
    std::vector<std::thread> threads;
    std::vector<Image> images(4);
    for (Image& image : images)
        threads.emplace_back([&] { image = read_image(folder_ / "b.hdr", ColorSpace::linear); });
    for (std::thread& thread : threads) thread.join();
    for (const Image& image : images) EXPECT_THAT(image.data, ElementsAre(0, 0.2, 0.4, 1));
}

TEST_F(PictureProcess, ThatIsMissingOrNoneOfOursIsAnError) {
    set_picture_program(folder_ / "bin/nothing");
    EXPECT_THAT(problem("picture"), HasSubstr("cannot start"));
    set_picture_program("/bin/false");
    EXPECT_THAT(problem("picture"), HasSubstr("has ended"));
    set_picture_program(folder_ / "bin/lancer");
    fs::remove(folder_ / "lib/lancer_images.so");
    EXPECT_THAT(problem("picture"), HasSubstr("lancer_images.so is missing"));
}

// The output of a process that a picture has taken over.
TEST(SharedPicture, IsCheckedInEveryByte) {
    const SharedMemory memory;
    SharedSink sink(memory.descriptor());
    StoredShape shape;
    shape.width = 3;
    shape.height = 2;
    shape.channels = 5;
    shape.type = SampleType::uint16;
    shape.orientation = 6;
    shape.extra_names = {"Z"};
    sink.shape(shape);
    const std::vector<std::uint16_t> pixels(30, 65535);
    sink.bytes(pixels.data(), 60);
    sink.finish("");
    std::string bytes(4096, '\0');
    const ssize_t size = pread(memory.descriptor(), bytes.data(), bytes.size(), 0);
    ASSERT_GT(size, 60);
    bytes.resize(static_cast<std::size_t>(size));
    ASSERT_EQ(read_shared(memory.descriptor()).problem, "");
    for (std::size_t at = 0; at < bytes.size() - 60; ++at) {
        for (int bit = 0; bit < 8; ++bit) {
            std::string damaged = bytes;
            damaged[at] = static_cast<char>(damaged[at] ^ 1 << bit);
            const SharedMemory other;
            write_at(other.descriptor(), damaged.data(), damaged.size(), 0);
            const SharedResult result = read_shared(other.descriptor());
            if (!result.problem.empty() || result.shape.width == 0) continue;
            const Image image = shared_image(other.descriptor(), result, ColorSpace::linear);
            EXPECT_EQ(image.data.size(), image.index(0, image.height));
            EXPECT_EQ(static_cast<std::size_t>(image.width * image.height * image.channels) *
                          bytes_of(result.shape.type),
                      60u);
        }
    }
}

}  // namespace
}  // namespace lancer::io
