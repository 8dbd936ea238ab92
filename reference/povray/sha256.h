// SHA-256 (FIPS 180-4): names cache entries by what they were made from.
#pragma once

#include <string>
#include <string_view>

namespace lancer::reference {

/// The digest of `bytes` as 64 lower-case hexadecimal digits.
std::string sha256(std::string_view bytes);

}  // namespace lancer::reference
