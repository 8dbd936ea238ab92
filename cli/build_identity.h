// Identifies the build of the program, as far as pictures may depend on it.
#pragma once

#include <string_view>

namespace lancer::cli {

/// A digest of all sources and of how they were compiled (cmake/build_identity.cmake), in
/// hexadecimal digits.
std::string_view build_identity();

}  // namespace lancer::cli
