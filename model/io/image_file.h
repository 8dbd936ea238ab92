// Image files: decoded to linear light, encoded by the ending of the name.
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
    /// Names and values to stand in a PNG, as text "lancer:NAME", or in an EXR, as an attribute of
    /// this name. Other formats hold none.
    std::vector<std::pair<std::string, std::string>> notes{};
};

/// True when `path` ends in a format that can be written: png exr hdr tif tiff jpg jpeg ppm; or is
/// a device or pipe, which gets a PNG without one.
bool is_writable_image_name(const std::string& path);

/// Writes `image` atomically, in the format that the name asks for. EXR: 32-bit float with all
/// channels, colours multiplied by alpha as is usual there. HDR and JPEG (8 bits): without alpha.
/// Extra channels are left out but in EXR. NaN becomes 0 and what a format cannot hold its nearest
/// value; EXR keeps both as they are. The same picture gives the same bytes. Throws FileError.
void write_image(const std::string& path, const Image& image, const ImageWriteOptions& options);

enum class ColorSpace {
    automatic,  ///< whole numbers are sRGB unless the file says otherwise; floats are linear
    linear,     ///< take the numbers as they stand
};

/// Reads an image into linear light: 1 channel (grey), 3 (RGB) or 4 (with alpha), and extra ones by
/// name (EXR). Its first bytes tell the format, whatever its name. Throws FileError when it cannot
/// be read, is truncated or damaged, is no image, or is too
/// large: more than 2^27 pixels, or 2^17 on a side.
Image read_image(const std::string& path, ColorSpace space = ColorSpace::automatic);

}  // namespace lancer::io
