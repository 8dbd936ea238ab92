// What must hold for every picture that a decoder of the project's own accepts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "model/diagnostic.h"
#include "model/io/image_file.h"

namespace lancer::io {

/// Decodes the bytes where `is_of_this_kind`: values from 0 to 1, as many as the size says, or a
/// FileError.
template <class IsOfThisKind, class Decode>
int fuzz_picture(const std::uint8_t* data, std::size_t size, IsOfThisKind is_of_this_kind,
                 Decode decode) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    if (!is_of_this_kind(bytes)) return 0;
    try {
        const Image image = decode(bytes, "t", ColorSpace::automatic);
        const std::size_t values = image.index(0, image.height);
        if (values == 0 || image.data.size() != values) std::abort();
        for (const double value : image.data) {
            if (!(value >= 0 && value <= 1)) std::abort();
        }
    } catch (const FileError&) {
    }
    return 0;
}

}  // namespace lancer::io
