#include "cli/memory_bound.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>

namespace lancer::cli {

std::uint64_t available_memory() {
    const auto pages = static_cast<std::uint64_t>(std::max(0L, sysconf(_SC_PHYS_PAGES)));
    std::uint64_t bytes = pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
    // Versions 2 and 1 of control groups; "max" stands for no bound and is not read as a number.
    for (const char* path :
         {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"}) {
        std::uint64_t bound = 0;
        if (std::ifstream(path) >> bound) bytes = std::min(bytes, bound);
    }
    return bytes;
}

std::uint64_t picture_bytes(std::int64_t width, std::int64_t height, int channels) {
    // The picture itself in double, and what an encoder makes of it: float or less.
    constexpr std::uint64_t bytes_per_value = sizeof(double) + sizeof(float);
    return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) *
           static_cast<std::uint64_t>(channels) * bytes_per_value;
}

}  // namespace lancer::cli
