// The messages between the program and its picture process, over a socket that preserves message
// boundaries.
#pragma once

#include <array>
#include <cstdint>

#include "model/io/picture_process.h"

namespace lancer::io {

/// Sent with two descriptors: input and output.
struct PictureRequest {
    PictureTask task{};
    std::array<char, 16> format{};  ///< ends with a zero
    std::uint64_t memory = 0;       ///< bytes
    std::uint64_t seconds = 0;
};

struct PictureReply {
    enum class Kind : std::uint32_t {
        ended = 1,   ///< `number` is the exit code
        killed,      ///< `number` is the signal
        timed_out,   ///< by the wall clock
        not_started  ///< `text` says why
    };
    Kind kind{};
    std::int32_t number = 0;
    std::array<char, 1024> text{};
};

/// The exit code of a process that ran out of memory.
inline constexpr int out_of_memory = 12;

/// The word on the command line that makes the program a picture process.
inline constexpr const char* picture_server_word = "serve-pictures";

}  // namespace lancer::io
