// Which build of the program this is, as far as pictures may depend on it.
#pragma once

#include <string_view>

namespace lancer::cli {

/// A digest of all sources and of how they were compiled (cmake/build_identity.cmake), as digits.
std::string_view build_identity();

}  // namespace lancer::cli
