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

/// Everything but the pixels. These follow in the row order of the file, with the samples of each
/// pixel together: colour, alpha, then the extra channels. Integers are encoded, floats are linear.
struct StoredShape {
    int width = 0;
    int height = 0;
    int channels = 0;
    SampleType type = SampleType::uint8;
    bool premultiplied = false;  ///< alpha is multiplied into the colours
    int orientation = 1;         ///< 1 to 8, as EXIF and TIFF number them: how to turn it upright
    std::vector<std::string> extra_names;
    /// For a picture to be written: ImageWriteOptions::notes.
    std::vector<std::pair<std::string, std::string>> notes{};

    std::size_t pixel_bytes() const { return static_cast<std::size_t>(channels) * bytes_of(type); }
    std::size_t row_bytes() const { return static_cast<std::size_t>(width) * pixel_bytes(); }
};

/// Receives what a picture library reads or writes, piece by piece.
class PictureSink {
  public:
    PictureSink() = default;
    PictureSink(const PictureSink&) = delete;
    PictureSink& operator=(const PictureSink&) = delete;
    virtual ~PictureSink() = default;
    /// For a picture that is read: called once, before its pixels.
    virtual void shape(const StoredShape& shape) = 0;
    /// Pixels of a picture that is read, or the bytes of a file that is written.
    virtual void bytes(const void* data, std::size_t size) = 0;
};

/// Memory that can be passed to another process; it has a size and content like a file.
class SharedMemory {
  public:
    /// Throws FileError when the system cannot allocate any.
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
    /// Called once, at the end. Marks the content as complete or, with a `problem`, replaces it.
    void finish(const std::string& problem);

  private:
    int memory_;
    StoredShape shape_;
    std::uint64_t written_ = 0;
};

/// The content that a SharedSink left. All of it is checked, because the file may have taken over
/// the process that read it.
struct SharedResult {
    std::string problem;      ///< why there is no content; the other members are then unset
    StoredShape shape;        ///< width 0: bytes of a file
    std::uint64_t first = 0;  ///< where the pixels or bytes begin
    std::uint64_t size = 0;
};
SharedResult read_shared(int memory);

/// The bytes of the encoded file. Throws FileError when the memory cannot be read.
std::string shared_bytes(int memory, const SharedResult& result);

/// The decoded picture, upright and in linear light. Throws FileError when the memory cannot be
/// read.
Image shared_image(int memory, const SharedResult& result, ColorSpace space);

}  // namespace lancer::io
