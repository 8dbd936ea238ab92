// The progress bar of a picture.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

#include "cli/terminal.h"

namespace lancer::cli {

/// One line on the terminal that is redrawn in place and removed by the destructor. Draws nothing
/// when standard error is not a terminal, or when `quiet`.
class ProgressBar {
  public:
    /// \param parts the number of pictures
    ProgressBar(const Terminal& terminal, bool quiet, std::size_t parts);
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// Begins the next picture.
    void begin_part(std::size_t part);
    /// Sets the text behind the bar that says what is being done.
    void set_label(std::string label) { label_ = std::move(label); }
    /// \param share of the current picture, 0..1
    void update(double share);
    /// Removes the bar, so that something else can be printed.
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
