// The seam to the shared library that knows the many image formats.
//
// Debian's OpenImageIO pulls in 261 shared libraries, 0.3 s and 129 MB merely to be linked, so it
// sits in a module of its own (image_module.cpp), loaded by image_module_loader.cpp when a picture
// in another format than PNG or PPM asks for it.
#pragma once

#include <string>

#include "model/image.h"

namespace lancer::io {

/// Pixels as a file stores them.
struct StoredImage {
    Image image;   ///< data: the steps 0..2^bits - 1, or the numbers themselves when bits is 32
    int bits = 8;  ///< 8 or 16: whole numbers, encoded; 32: floating point, linear
    bool premultiplied = false;  ///< alpha is multiplied into the colours
};

/// Both return why they failed, empty when they did not: exceptions stay on their side of the seam.
/// `format` is OpenImageIO's name: openexr, hdr, tiff or jpeg.
struct ImageModule {
    std::string (*read)(const std::string& path, const std::string& format, StoredImage& result);
    std::string (*write)(const std::string& path, const std::string& format,
                         const StoredImage& stored);
};

/// Loads the module at the first call; any thread. Throws FileError when it is missing.
const ImageModule& image_module();

}  // namespace lancer::io

/// What the module exports.
extern "C" const lancer::io::ImageModule* lancer_image_module();
