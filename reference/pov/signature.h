// A mark in exported files, by which `export` knows what it wrote itself.
#pragma once

#include <string>
#include <string_view>

namespace lancer::reference {

/// The bytes of a `.pov` or a PNG with a mark at their end that holds their digest: a comment, or a
/// text chunk. Neither changes a picture.
std::string with_signature(const std::string& bytes);

/// Whether `with_signature` made these bytes, and nobody has changed them since.
bool is_signed(std::string_view bytes);

}  // namespace lancer::reference
