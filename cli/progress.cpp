#include "cli/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace lancer::cli {
namespace {

constexpr auto between_drawings = std::chrono::milliseconds(100);
constexpr int widest_bar = 30;
constexpr int room_for_text = 40;

/// Text that standard error does not accept is lost.
void put(const std::string& text) {
    std::fwrite(text.data(), 1, text.size(), stderr);
    std::fflush(stderr);
}

}  // namespace

ProgressBar::ProgressBar(const Terminal& terminal, bool quiet, std::size_t parts)
    : terminal_(terminal), shown_(terminal.is_interactive() && !quiet), parts_(parts) {}

ProgressBar::~ProgressBar() {
    clear();
}

void ProgressBar::begin_part(std::size_t part) {
    part_ = part;
}

void ProgressBar::update(double share) {
    const auto now = Clock::now();
    if (!shown_ || now - last_ < between_drawings) return;
    last_ = now;
    const double done = (static_cast<double>(part_) + share) / static_cast<double>(parts_);
    const double elapsed = std::chrono::duration<double>(now - begin_).count();

    std::string text;
    const int width = std::min(widest_bar, terminal_.columns() - room_for_text);
    if (width > 0) {
        const int full = static_cast<int>(done * width);
        text += '[';
        text.append(static_cast<std::size_t>(full), '#');
        text.append(static_cast<std::size_t>(width - full), '.');
        text += "] ";
    }
    text += fmt::format("{:3.0f} %", std::floor(done * 100));
    if (parts_ > 1) text += fmt::format(", picture {} of {}", part_ + 1, parts_);
    // An estimate from the first moments would only jump.
    if (done > 0 && elapsed > 0.5)
        text += fmt::format(", {} left", as_clock_time(elapsed * (1 - done) / done));

    if (!label_.empty()) text += ", " + label_;
    const std::size_t length = text.size();
    text.append(drawn_ > length ? drawn_ - length : 0, ' ');
    drawn_ = length;
    put("\r" + text);
}

void ProgressBar::clear() {
    if (drawn_ == 0) return;
    put(fmt::format("\r{:{}}\r", "", drawn_));
    drawn_ = 0;
}

std::string as_clock_time(double seconds) {
    constexpr double longest = 359999;  // 99:59:59
    const auto whole = static_cast<long>(std::ceil(std::clamp(seconds, 0.0, longest)));
    const long hours = whole / 3600;
    const long minutes = whole / 60 % 60;
    if (hours > 0) return fmt::format("{}:{:02}:{:02}", hours, minutes, whole % 60);
    return fmt::format("{}:{:02}", minutes, whole % 60);
}

}  // namespace lancer::cli
