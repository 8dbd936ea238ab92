// The interface of the shared library for most image formats.
//
// Linking Debian's OpenImageIO alone loads 261 shared libraries and costs 0.3 s and 129 MB. So it
// is in a module of its own (module/), which the picture process loads at its first picture.
#pragma once

#include <string>
#include <string_view>

#include "model/io/row_functions.h"
#include "model/io/stored_image.h"

namespace lancer::io {

/// `read` and `write` return the reason of a failure, or an empty text. No exceptions leave the
/// module except those of the sink and std::bad_alloc. `format` is openexr, hdr, tiff or jpeg.
struct ImageModule {
    std::string (*read)(std::string_view bytes, const std::string& format, PictureSink& sink);
    std::string (*write)(const StoredShape& shape, const void* pixels, const std::string& format,
                         PictureSink& sink);
    /// The same row by row into an open file, from its beginning. The pictures are always this
    /// program's own, so it may be called without a separate process.
    std::string (*write_rows)(const StoredShape& shape, const RowsOf& rows,
                              const std::string& format, int file);
    /// From now on this process and its future threads cannot open files or connections and cannot
    /// start processes, as far as the system can enforce that.
    void (*confine)();
};

/// Loads the module at the first call. Throws FileError when it is missing.
const ImageModule& image_module();

}  // namespace lancer::io

/// The function that the module exports.
extern "C" const lancer::io::ImageModule* lancer_image_module();
