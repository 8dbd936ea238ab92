// Text for people on standard error, coloured only on a terminal.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/diagnostic.h"

namespace lancer::cli {

class Terminal {
  public:
    /// Reads the state of standard error and the environment: NO_COLOR and TERM=dumb switch colours
    /// off.
    Terminal();

    bool is_interactive() const { return interactive_; }
    int columns() const;  ///< width of the window, 80 when unknown

    /// Shows the diagnostics in the order of their places, and returns how many are errors.
    std::size_t show(std::vector<Diagnostic> found, const SourceMap& sources) const;
    /// `lancer: error: message`
    void error(const std::string& message) const;
    /// A line of plain text.
    void line(std::string_view text) const;
    /// Many lines of plain text, in few writes.
    void lines(const std::vector<std::string>& texts) const;

  private:
    bool interactive_ = false;
    bool colors_ = false;
};

/// The output of format(), with escape sequences that colour its kinds and carets.
std::string with_colors(std::string_view diagnostic);

}  // namespace lancer::cli
