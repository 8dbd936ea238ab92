// Refuses pictures that do not fit into memory before anything is allocated.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace lancer::cli {

/// The files with the memory limits of control groups, versions 2 and 1.
std::vector<std::string> control_group_bounds();

/// The bytes that this process may use: the machine's memory, or less if its control group or the
/// shell (ulimit) sets a limit. Each of the files `bounds` holds a number of bytes or "max";
/// missing files are ignored.
std::uint64_t available_memory(const std::vector<std::string>& bounds = control_group_bounds());

/// The bytes that a picture takes while it is rendered and written.
std::uint64_t picture_bytes(std::int64_t width, std::int64_t height, int channels);

}  // namespace lancer::cli
