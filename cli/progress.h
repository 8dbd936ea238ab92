// The bar that shows how far a picture is.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

#include "cli/terminal.h"

namespace lancer::cli {

/// One line on the terminal that is drawn over itself, and is gone when the object is. Draws
/// nothing when nobody looks.
class ProgressBar {
  public:
    /// \param parts how many pictures the whole consists of
    ProgressBar(const Terminal& terminal, bool quiet, std::size_t parts);
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// Says that the next picture begins.
    void begin_part(std::size_t part);
    /// What is being done, shown behind the bar.
    void set_label(std::string label) { label_ = std::move(label); }
    /// \param share of the current picture, 0..1
    void update(double share);
    /// Takes the bar off the screen, so that something else can be printed.
    void clear();

  private:
    using Clock = std::chrono::steady_clock;

    const Terminal& terminal_;
    bool shown_;
    std::size_t parts_;
    std::size_t part_ = 0;
    std::string label_;
    std::size_t drawn_ = 0;  ///< characters on the screen
    Clock::time_point begin_ = Clock::now();
    Clock::time_point last_{};
};

/// `1:02:03`, `2:03`, or `0:03`.
std::string as_clock_time(double seconds);

}  // namespace lancer::cli
