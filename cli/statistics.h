// The cost of a run: --stats.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "accuracy/cut_bound.h"
#include "accuracy/error_picture.h"
#include "model/scene.h"
#include "tracer/render.h"

namespace lancer::cli {

/// Seconds are wall-clock. Seconds and rays are summed over all frames; counts are those of the
/// last frame.
struct Statistics {
    double parse = 0;
    double evaluate = 0;
    double build = 0;
    double trace = 0;
    double write = 0;
    double total = 0;  ///< of the whole process
    RayCounts rays;
    int threads = 0;
    std::string level;  ///< of rays side by side: Renderer::level()
    std::uint64_t frames = 0;
    WorldCounts world;
    std::uint64_t cameras = 0;
    std::uint64_t materials = 0;
    std::uint64_t textures = 0;
    std::optional<accuracy::ErrorReport> error;  ///< of the frame with the largest error

    std::optional<accuracy::CutBound> cut;  ///< the largest of any frame

    /// Keeps the report with the larger error.
    void keep_worse(const accuracy::ErrorReport& report);
    void keep_larger(const accuracy::CutBound& bound);
    void add(const RayCounts& counts);
    void count(const Scene& scene, const WorldCounts& counts);
};

/// The largest amount of memory that the process has held so far.
std::uint64_t peak_memory_bytes();

/// The JSON object that docs/command-line.md describes, with a line feed at its end.
std::string to_json(const Statistics& statistics);
/// The same for people.
std::string to_text(const Statistics& statistics);

}  // namespace lancer::cli
