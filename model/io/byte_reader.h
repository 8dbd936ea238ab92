// Reads numbers of a binary file in either byte order.
#pragma once

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "model/diagnostic.h"

namespace lancer::io {

static_assert(std::endian::native == std::endian::little ||
              std::endian::native == std::endian::big);

/// Reads through `bytes`, which must outlive it. `first` is their offset in the file, for messages.
class ByteReader {
  public:
    ByteReader(std::string_view bytes, std::string name, std::endian order, std::size_t first = 0)
        : bytes_(bytes),
          name_(std::move(name)),
          swap_(order != std::endian::native),
          first_(first) {}

    /// The next value of an arithmetic type. Throws FileError when the file is too short.
    template <class Value>
    Value read() {
        if (bytes_left() < sizeof(Value)) throw error("the file is truncated");
        char buffer[sizeof(Value)];
        std::memcpy(buffer, bytes_.data() + at_, sizeof(Value));
        if (swap_) {
            for (std::size_t i = 0; i < sizeof(Value) / 2; ++i) {
                std::swap(buffer[i], buffer[sizeof(Value) - 1 - i]);
            }
        }
        Value value;
        std::memcpy(&value, buffer, sizeof(Value));
        at_ += sizeof(Value);
        return value;
    }

    void skip(std::uint64_t count) {
        if (count > bytes_left()) throw error("the file is truncated");
        at_ += static_cast<std::size_t>(count);
    }

    std::size_t bytes_left() const { return bytes_.size() - at_; }

    /// "name: byte 84: message"
    FileError error(const std::string& message) const {
        return FileError(fmt::format("{}: byte {}: {}", name_, first_ + at_, message));
    }

  private:
    std::string_view bytes_;
    std::string name_;
    bool swap_;
    std::size_t first_;
    std::size_t at_ = 0;
};

}  // namespace lancer::io
