// A picture as its file stores it, and its form in memory that two processes share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "model/image.h"
#include "model/io/image_file.h"

namespace lancer::io {

enum class SampleType : std::uint32_t { uint8 = 1, uint16, float32, float64 };

constexpr std::size_t bytes_of(SampleType type) {
    switch (type) {
        case SampleType::uint8:
            return 1;
        case SampleType::uint16:
            return 2;
        case SampleType::float32:
            return 4;
        case SampleType::float64:
            return 8;
    }
    return 0;
}

/// Everything but the pixels. These follow row by row from the file's first, the samples of a pixel
/// side by side: colour, alpha, then the extra channels. Whole numbers are encoded, floats linear.
struct StoredShape {
    int width = 0;
    int height = 0;
    int channels = 0;
    SampleType type = SampleType::uint8;
    bool premultiplied = false;  ///< alpha is multiplied into the colours
    int orientation = 1;         ///< 1 to 8, as EXIF and TIFF number them: how to turn it upright
    std::vector<std::string> extra_names;
    /// Of a picture that is written: ImageWriteOptions::notes.
    std::vector<std::pair<std::string, std::string>> notes{};

    std::size_t row_bytes() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(channels) *
               bytes_of(type);
    }
};

/// Takes what a picture library reads or writes, piece by piece.
class PictureSink {
  public:
    PictureSink() = default;
    PictureSink(const PictureSink&) = delete;
    PictureSink& operator=(const PictureSink&) = delete;
    virtual ~PictureSink() = default;
    /// Of a picture that is read: once, before its pixels.
    virtual void shape(const StoredShape& shape) = 0;
    /// Pixels of a picture that is read, or the bytes of a file that is written.
    virtual void bytes(const void* data, std::size_t size) = 0;
};

/// Memory that can be handed to another process; it has a size and a content like a file.
class SharedMemory {
  public:
    /// Throws FileError when the system has none left.
    SharedMemory();
    ~SharedMemory();
    SharedMemory(const SharedMemory&) = delete;
    SharedMemory& operator=(const SharedMemory&) = delete;
    int descriptor() const { return descriptor_; }

  private:
    int descriptor_;
};

/// Throws FileError.
void write_at(int memory, const void* data, std::size_t size, std::uint64_t at);

/// Writes into shared memory, in the form that the functions below read.
class SharedSink : public PictureSink {
  public:
    explicit SharedSink(int memory) : memory_(memory) {}
    void shape(const StoredShape& shape) override;
    void bytes(const void* data, std::size_t size) override;
    /// Once, at the end: what is there is whole, or (with a `problem`) there is nothing but that.
    void finish(const std::string& problem);

  private:
    int memory_;
    StoredShape shape_;
    std::uint64_t written_ = 0;
};

/// What a SharedSink left. All of it is checked: the process that wrote it may have been taken over
/// by the file that it read.
struct SharedResult {
    std::string problem;      ///< why there is nothing; the other members are unset then
    StoredShape shape;        ///< width 0: bytes of a file
    std::uint64_t first = 0;  ///< where the pixels or bytes begin
    std::uint64_t size = 0;
};
SharedResult read_shared(int memory);

/// The file that was written. Throws FileError when the memory cannot be read.
std::string shared_bytes(int memory, const SharedResult& result);

/// The picture that was read, upright and in linear light. Throws FileError when the memory cannot
/// be read.
Image shared_image(int memory, const SharedResult& result, ColorSpace space);

}  // namespace lancer::io
