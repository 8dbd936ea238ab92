#include "cli/memory_bound.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

namespace lancer::cli {

std::vector<std::string> control_group_bounds() {
    return {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"};
}

std::uint64_t available_memory(const std::vector<std::string>& bounds) {
    const auto pages = static_cast<std::uint64_t>(std::max(0L, sysconf(_SC_PHYS_PAGES)));
    std::uint64_t bytes = pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
    for (const std::string& path : bounds) {
        std::uint64_t bound = 0;  // "max" does not parse as a number
        if (std::ifstream(path) >> bound) bytes = std::min(bytes, bound);
    }
    for (const auto limit : {RLIMIT_AS, RLIMIT_DATA}) {
        rlimit bound{};  // RLIM_INFINITY is the largest number
        if (getrlimit(limit, &bound) == 0)
            bytes = std::min(bytes, static_cast<std::uint64_t>(bound.rlim_cur));
    }
    return bytes;
}

std::uint64_t picture_bytes(std::int64_t width, std::int64_t height, int channels) {
    // At most the picture in double, as a target error needs it, and the samples of the file, which
    // are floats or less.
    constexpr std::uint64_t bytes_per_value = sizeof(double) + sizeof(float);
    return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) *
           static_cast<std::uint64_t>(channels) * bytes_per_value;
}

}  // namespace lancer::cli
