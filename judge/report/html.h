// Text for use in HTML.
#pragma once

#include <string>
#include <string_view>

namespace lancer::judge {

/// `text` with & < > " ' as entities: safe in elements and in quoted attributes.
std::string escaped(std::string_view text);

/// A file name as a relative URL: all characters but letters, digits and -._ are percent-encoded.
std::string url_of(std::string_view name);

/// Base64 by RFC 4648, with padding.
std::string base64(std::string_view bytes);

/// A number for people: `digits` significant digits, exponents without padding (2e-5).
std::string shown(double value, int digits = 3);

/// Keeps letters, digits and `-`: for ids and class names.
std::string slug(std::string_view text);

}  // namespace lancer::judge
