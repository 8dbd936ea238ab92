// Pictures that do not fit are refused before anything is allocated.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace lancer::cli {

/// Of versions 2 and 1 of control groups.
std::vector<std::string> control_group_bounds();

/// Bytes that this process may hope for: the machine's memory, or what its control group or the
/// shell's limits (ulimit) allow. The files hold a number of bytes each, or "max"; those that are
/// missing count for nothing.
std::uint64_t available_memory(const std::vector<std::string>& bounds = control_group_bounds());

/// Bytes that a picture takes while it is rendered and written.
std::uint64_t picture_bytes(std::int64_t width, std::int64_t height, int channels);

}  // namespace lancer::cli
