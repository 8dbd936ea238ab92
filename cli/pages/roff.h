// Text for man(7).
#pragma once

#include <string>
#include <string_view>

namespace lancer::cli {

/// Escapes characters that roff would read as commands. Hyphens become ASCII hyphens, so that
/// examples can be copied into a shell. Text in backticks becomes bold.
std::string roff(std::string_view text);

}  // namespace lancer::cli
