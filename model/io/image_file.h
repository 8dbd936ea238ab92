// Image files: decoded to linear light, encoded by the ending of the name.
#pragma once

#include <string>

#include "model/image.h"

namespace lancer::io {

struct ImageWriteOptions {
    int bits = 8;         ///< 8 or 16, for formats of whole numbers (PNG, TIFF, PPM)
    bool linear = false;  ///< whole-number formats: no sRGB curve
};

/// True when `path` ends in a format that can be written: png exr hdr tif tiff jpg jpeg ppm.
bool is_writable_image_name(const std::string& path);

/// Writes `image` atomically. Throws FileError.
void write_image(const std::string& path, const Image& image, const ImageWriteOptions& options);

enum class ColorSpace {
    automatic,  ///< 8-bit whole numbers and 16-bit PNG are sRGB unless the file says otherwise;
                ///< floats are linear
    linear,     ///< take the numbers as they stand
};

/// Reads an image into linear light with 1 to 4 (or more, EXR) channels. Throws FileError.
Image read_image(const std::string& path, ColorSpace space = ColorSpace::automatic);

}  // namespace lancer::io
