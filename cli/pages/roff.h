// Text for man(7).
#pragma once

#include <string>
#include <string_view>

namespace lancer::cli {

/// Characters that roff would take for commands are escaped, and hyphens are those of ASCII, so
/// that what a page shows can be copied to a shell. What stands in backticks is bold.
std::string roff(std::string_view text);

}  // namespace lancer::cli
