// A sink for fuzzing the readers of the picture process: it checks what they promise.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "model/io/stored_image.h"

namespace lancer::io {

class CountingSink : public PictureSink {
  public:
    void shape(const StoredShape& shape) override {
        if (shape_.width != 0) std::abort();
        shape_ = shape;
    }
    void bytes(const void* data, std::size_t size) override {
        const auto* values = static_cast<const unsigned char*>(data);
        // checks that all bytes are readable
        for (std::size_t i = 0; i < size; ++i) sum_ = sum_ * 31 + values[i];
        count_ += size;
    }
    bool whole() const {
        return shape_.width > 0 && shape_.height > 0 &&
               count_ == shape_.row_bytes() * static_cast<std::size_t>(shape_.height);
    }
    std::uint64_t sum() const { return sum_; }

  private:
    StoredShape shape_;
    std::size_t count_ = 0;
    std::uint64_t sum_ = 0;
};

/// Reads the bytes twice. The result is a reason or a complete picture, the same both times.
template <class Read>
int fuzz_stored_picture(const std::uint8_t* data, std::size_t size, Read read) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    CountingSink first;
    CountingSink second;
    const std::string problem = read(bytes, first);
    if (problem != read(bytes, second) || first.sum() != second.sum()) std::abort();
    if (problem.empty() && !first.whole()) std::abort();
    return 0;
}

}  // namespace lancer::io
