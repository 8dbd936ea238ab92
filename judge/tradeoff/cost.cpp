#include "judge/tradeoff/cost.h"

#include <malloc.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <string>

namespace lancer::judge {
namespace {

double processor_seconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double wall_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

/// The value of a line such as `VmHWM: 123 kB` of /proc/self/status, in bytes.
std::optional<std::uint64_t> status_bytes(const std::string& name) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        if (!line.starts_with(name + ":")) continue;
        std::uint64_t kilobytes = 0;
        for (const char c : line)
            if (c >= '0' && c <= '9')
                kilobytes = 10 * kilobytes + static_cast<unsigned char>(c - '0');
        return kilobytes * 1024;
    }
    return std::nullopt;
}

/// Resets the system's record of the peak memory.
bool reset_peak() {
    std::ofstream clear("/proc/self/clear_refs");
    clear << "5" << std::flush;
    return clear.good();
}

}  // namespace

CostMeter::CostMeter() {
    malloc_trim(0);  // gives back what earlier work has freed
    if (reset_peak()) held_ = status_bytes("VmRSS");
    wall_ = wall_seconds();
    processor_ = processor_seconds();
}

Cost CostMeter::cost() const {
    Cost cost;
    cost.processor = processor_seconds() - processor_;
    cost.wall = wall_seconds() - wall_;
    const std::optional<std::uint64_t> peak = status_bytes("VmHWM");
    if (held_ && peak) cost.memory_bytes = *peak - std::min(*peak, *held_);
    return cost;
}

}  // namespace lancer::judge
