// Image files: decoded to linear light, encoded in the format of the name's ending.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model/image.h"

namespace lancer::io {

struct ImageWriteOptions {
    int bits = 8;         ///< 8 or 16, for formats of whole numbers (PNG, TIFF, PPM)
    bool linear = false;  ///< whole-number formats: no sRGB curve
    /// Names and values to be stored in a PNG, as text "lancer:NAME", or in an EXR, as an attribute
    /// with this name. Other formats cannot store them.
    std::vector<std::pair<std::string, std::string>> notes{};
};

/// True when `path` ends in a format that can be written: png exr hdr tif tiff jpg jpeg ppm. Also
/// true for a device or pipe, which gets a PNG if its name has no ending.
bool is_writable_image_name(const std::string& path);

/// Writes `image` atomically, in the format of the name's ending. EXR: 32-bit floats with all
/// channels; colours are premultiplied by alpha, as is usual there. HDR and JPEG (8 bits): without
/// alpha. Only EXR keeps extra channels. NaN becomes 0, and a value that a format cannot store
/// becomes its nearest value; EXR keeps both. The same picture gives the same bytes. Throws
/// FileError.
void write_image(const std::string& path, const Image& image, const ImageWriteOptions& options);

enum class ColorSpace {
    automatic,  ///< integers are sRGB unless the file says otherwise; floats are linear
    linear,     ///< use the values unchanged
};

/// Reads an image into linear light: 1 channel (grey), 3 (RGB) or 4 (with alpha), and named extra
/// channels (EXR). The first bytes determine the format, whatever the name. Throws FileError when
/// the file cannot be read, is truncated or damaged, is not an image, or is too large: more than
/// 2^27 pixels, or more than 2^17 on a side.
Image read_image(const std::string& path, ColorSpace space = ColorSpace::automatic);

}  // namespace lancer::io
