// Pictures that do not fit are refused before anything is allocated.
#pragma once

#include <cstdint>

namespace lancer::cli {

/// Bytes that this process may hope for: the machine's memory, or what its control group allows.
std::uint64_t available_memory();

/// Bytes that a picture takes while it is rendered and written.
std::uint64_t picture_bytes(std::int64_t width, std::int64_t height, int channels);

}  // namespace lancer::cli
