// Converts words of the command line to values. A number must be a whole word, within its bounds,
// and does not depend on the locale.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tracer/render.h"

// CLI11 is slow to compile, so only the files that add options include it.
namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace lancer::cli {

/// `640x480`; each side 1 to 65535
struct PictureSize {
    int width = 0;
    int height = 0;
};

/// `1..10`: both ends are included; the first is not above the last.
struct FrameRange {
    std::int64_t first = 0;
    std::int64_t last = 0;

    std::uint64_t count() const { return static_cast<std::uint64_t>(last - first) + 1; }
    /// 0 at the first frame, 1 at the last; 0 when there is only one frame. In a loop, 1 belongs to
    /// the frame after the last, which is the first again.
    double time(std::int64_t frame, bool loop = false) const;
};

/// `1%:2`: at most 1 % of the pixels may differ by more than 2 steps of 8 bits.
struct OffTarget {
    double share = 0;  ///< 0.0003 to 0.5
    double steps = 0;  ///< 0.1 to 254
};

/// `3/12`: the third of twelve. Both lie between 1 and 65535, the largest number of rows.
struct PartOf {
    int number = 1;
    int count = 1;

    /// Whether the item with this index belongs to the part. Items are dealt to the parts in turn.
    bool has(std::int64_t index) const { return index % count == number - 1; }
};

/// Each function throws UsageError, which says what is expected.
PictureSize parse_size(const std::string& text);
PartOf parse_part(const std::string& text);
Crop parse_crop(const std::string& text);
FrameRange parse_frames(const std::string& text);
OffTarget parse_off_target(const std::string& text);
/// Throws UsageError when the crop leaves the picture.
void check_crop(const Crop& crop, int width, int height);
double parse_number(const std::string& text);
std::int64_t parse_whole_number(const std::string& text);

/// Add options that set `target` when they are given.
CLI::Option* add_number(CLI::App& app, const std::string& name, std::optional<double>& target,
                        double least, double most, const std::string& help);
CLI::Option* add_whole_number(CLI::App& app, const std::string& name,
                              std::optional<std::int64_t>& target, std::int64_t least,
                              std::int64_t most, const std::string& help);

/// Adds an option that takes one of `words` and calls `take` with its index. Help, completions and
/// the error about another word list them: `'fin' is no NOUN: expected draft or fine`.
CLI::Option* add_choice(CLI::App& app, const std::string& name, std::vector<std::string> words,
                        const std::string& noun, std::function<void(std::size_t)> take,
                        const std::string& help);

}  // namespace lancer::cli
