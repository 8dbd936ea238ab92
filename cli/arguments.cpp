#include "cli/arguments.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

#include "cli/session.h"

namespace lancer::cli {
namespace {

/// The whole of `text` as a number, or nothing.
template <class Number>
std::optional<Number> read(std::string_view text) {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

/// N whole numbers with `separator` between them, or nothing.
template <std::size_t N>
std::optional<std::array<int, N>> read_list(std::string_view text, char separator) {
    std::array<int, N> values{};
    for (std::size_t i = 0; i < N; ++i) {
        const std::size_t end = i + 1 < N ? text.find(separator) : text.size();
        if (end == std::string_view::npos) return std::nullopt;
        const auto value = read<int>(text.substr(0, end));
        if (!value) return std::nullopt;
        values[i] = *value;
        text.remove_prefix(i + 1 < N ? end + 1 : end);
    }
    return values;
}

}  // namespace

double FrameRange::time(std::int64_t frame, bool loop) const {
    if (first == last) return 0;
    return static_cast<double>(frame - first) / static_cast<double>(last - first + (loop ? 1 : 0));
}

PictureSize parse_size(const std::string& text) {
    constexpr int largest = 65535;  // as in a scene's image { … }
    const auto sides = read_list<2>(text, 'x');
    const auto fits = [](int side) { return side >= 1 && side <= largest; };
    if (!sides || !fits((*sides)[0]) || !fits((*sides)[1])) {
        throw UsageError(fmt::format(
            "'{}' is not a picture size: expected WIDTHxHEIGHT of 1 to {} pixels, as in 640x480",
            text, largest));
    }
    return {(*sides)[0], (*sides)[1]};
}

PartOf parse_part(const std::string& text) {
    constexpr int most = 65535;
    const auto part = read_list<2>(text, '/');
    if (!part || (*part)[1] < 1 || (*part)[1] > most)
        throw UsageError(fmt::format("'{}' is not a part: expected K/N, as in 3/12", text));
    const auto [number, count] = *part;
    if (number < 1 || number > count) {
        throw UsageError(fmt::format("there is no part {} of {}: parts are numbered from 1 to {}",
                                     number, count, count));
    }
    return {number, count};
}

Crop parse_crop(const std::string& text) {
    const auto v = read_list<4>(text, ',');
    if (!v || (*v)[0] < 0 || (*v)[1] < 0 || (*v)[2] < 1 || (*v)[3] < 1) {
        throw UsageError(fmt::format(
            "'{}' is not a crop: expected X,Y,WIDTH,HEIGHT in pixels from the top left corner",
            text));
    }
    return {(*v)[0], (*v)[1], (*v)[2], (*v)[3]};
}

FrameRange parse_frames(const std::string& text) {
    // Far more frames than anybody renders; small enough that differences and names cannot
    // overflow.
    constexpr std::int64_t largest = 1'000'000'000;
    const std::size_t dots = text.find("..");
    if (dots != std::string::npos) {
        const auto first = read<std::int64_t>(std::string_view(text).substr(0, dots));
        const auto last = read<std::int64_t>(std::string_view(text).substr(dots + 2));
        if (first && last && std::abs(*first) <= largest && std::abs(*last) <= largest) {
            if (*first > *last)
                throw UsageError(fmt::format(
                    "'{}' contains no frame: the first number is greater than the last", text));
            return {*first, *last};
        }
    }
    throw UsageError(
        fmt::format("'{}' is not a range of frames: expected A..B, as in 1..10", text));
}

OffTarget parse_off_target(const std::string& text) {
    const std::size_t colon = text.find(':');
    if (colon != std::string::npos) {
        std::string_view percent = std::string_view(text).substr(0, colon);
        if (percent.ends_with('%')) percent.remove_suffix(1);
        const auto share = read<double>(percent);
        const auto steps = read<double>(std::string_view(text).substr(colon + 1));
        if (share && steps) {
            if (!(*share >= 0.03 && *share <= 50))
                throw UsageError(fmt::format(
                    "--max-off {}: the share of pixels must be between 0.03% and 50%", text));
            if (!(*steps >= 0.1 && *steps <= 254))
                throw UsageError(fmt::format(
                    "--max-off {}: the number of steps must be between 0.1 and 254", text));
            return {*share / 100, *steps};
        }
    }
    throw UsageError(fmt::format(
        "--max-off {}: expected P%:N, as in 1%:2: at most 1 % of the pixels off by more than 2 "
        "steps of 8 bits",
        text));
}

void check_crop(const Crop& crop, int width, int height) {
    if (crop.x >= width || crop.y >= height || crop.width > width - crop.x ||
        crop.height > height - crop.y) {
        throw UsageError(fmt::format("--crop {},{},{},{} is not within the picture of {}x{} pixels",
                                     crop.x, crop.y, crop.width, crop.height, width, height));
    }
}

double parse_number(const std::string& text) {
    const auto value = read<double>(text);
    if (!value || !std::isfinite(*value))
        throw UsageError(fmt::format("'{}' is not a number", text));
    return *value;
}

std::int64_t parse_whole_number(const std::string& text) {
    const auto value = read<std::int64_t>(text);
    if (!value) throw UsageError(fmt::format("'{}' is not a whole number", text));
    return *value;
}

CLI::Option* add_number(CLI::App& app, const std::string& name, std::optional<double>& target,
                        double least, double most, const std::string& help) {
    return app.add_option_function<std::string>(
        name,
        [&target, name, least, most](const std::string& text) {
            const double value = parse_number(text);
            if (value < least || value > most) {
                if (least == std::numeric_limits<double>::denorm_min())
                    throw UsageError(fmt::format("{} must be greater than 0", name));
                throw UsageError(
                    most == std::numeric_limits<double>::max()
                        ? fmt::format("{} must be at least {}", name, least)
                        : fmt::format("{} must be between {} and {}", name, least, most));
            }
            target = value;
        },
        help);
}

CLI::Option* add_whole_number(CLI::App& app, const std::string& name,
                              std::optional<std::int64_t>& target, std::int64_t least,
                              std::int64_t most, const std::string& help) {
    return app.add_option_function<std::string>(
        name,
        [&target, name, least, most](const std::string& text) {
            const std::int64_t value = parse_whole_number(text);
            if (value < least || value > most)
                throw UsageError(fmt::format("{} must be between {} and {}", name, least, most));
            target = value;
        },
        help);
}

CLI::Option* add_choice(CLI::App& app, const std::string& name, std::vector<std::string> words,
                        const std::string& noun, std::function<void(std::size_t)> take,
                        const std::string& help) {
    const std::string value = fmt::format("{}", fmt::join(words, "|"));
    return app
        .add_option_function<std::string>(
            name,
            [words = std::move(words), noun, take = std::move(take)](const std::string& text) {
                const auto found = std::ranges::find(words, text);
                if (found == words.end()) {
                    throw UsageError(fmt::format("'{}' is not a {}: expected {} or {}", text, noun,
                                                 fmt::join(words.begin(), words.end() - 1, ", "),
                                                 words.back()));
                }
                take(static_cast<std::size_t>(found - words.begin()));
            },
            help)
        ->type_name(value);
}

}  // namespace lancer::cli
