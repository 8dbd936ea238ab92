// A mark in exported files, by which `export` recognizes its own files.
#pragma once

#include <string>
#include <string_view>

namespace lancer::reference {

/// Appends a mark with the digest of the bytes to a `.pov` or PNG file, as a comment or a text
/// chunk. It does not change the picture.
std::string with_signature(const std::string& bytes);

/// Whether with_signature() made these bytes and they are unchanged.
bool is_signed(std::string_view bytes);

}  // namespace lancer::reference
