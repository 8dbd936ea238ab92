// The seam to the shared library that knows the many image formats.
//
// Debian's OpenImageIO pulls in 261 shared libraries, 0.3 s and 129 MB merely to be linked, so it
// sits in a module of its own (module/), which the picture process loads at its first picture.
#pragma once

#include <string>
#include <string_view>

#include "model/io/row_functions.h"
#include "model/io/stored_image.h"

namespace lancer::io {

/// read and write return why they failed, empty when they did not: exceptions other than those of
/// the sink and of memory stay on their side of the seam. `format` is openexr, hdr, tiff or jpeg.
struct ImageModule {
    std::string (*read)(std::string_view bytes, const std::string& format, PictureSink& sink);
    std::string (*write)(const StoredShape& shape, const void* pixels, const std::string& format,
                         PictureSink& sink);
    /// The same row by row into an open file, from its beginning. The pictures are those that this
    /// program made, so it may be called without a process of its own.
    std::string (*write_rows)(const StoredShape& shape, const RowsOf& rows,
                              const std::string& format, int file);
    /// From now on this process, with the threads that it may yet start, opens no file and no
    /// connection and starts no process, as far as the system can see to that.
    void (*confine)();
};

/// Loads the module at the first call. Throws FileError when it is missing.
const ImageModule& image_module();

}  // namespace lancer::io

/// What the module exports.
extern "C" const lancer::io::ImageModule* lancer_image_module();
