// An open file, and a function that writes bytes to it completely.
#pragma once

#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <string>
#include <string_view>

#include "model/io/system_error.h"

namespace lancer::io {

/// Closes the file at the end of its scope, except for standard input.
class Descriptor {
  public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() {
        if (number_ > STDIN_FILENO) close(number_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int number() const { return number_; }

  private:
    int number_;
};

/// Writes all bytes at the offset `at`. Throws FileError, whose message names `path`.
inline void write_all_at(int file, std::string_view bytes, std::uint64_t at,
                         const std::string& path) {
    while (!bytes.empty()) {
        const ssize_t count = pwrite(file, bytes.data(), bytes.size(), static_cast<off_t>(at));
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) throw system_error("cannot write", path, errno);
        bytes.remove_prefix(static_cast<std::size_t>(count));
        at += static_cast<std::uint64_t>(count);
    }
}

}  // namespace lancer::io
