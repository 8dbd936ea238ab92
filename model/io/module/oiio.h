// Reads EXR and Radiance files, and writes all formats, with OpenImageIO.
#pragma once

#include <string>
#include <string_view>

#include "model/io/row_functions.h"
#include "model/io/stored_image.h"

namespace lancer::io {

/// Initializes OpenImageIO once, so that forked processes need not.
void warm_up_oiio();

/// All functions return the reason of a failure, or an empty text.
std::string read_with_oiio(std::string_view bytes, const std::string& format, PictureSink& sink);
std::string write_with_oiio(const StoredShape& shape, const void* pixels, const std::string& format,
                            PictureSink& sink);
/// The same bytes into an open file, from consecutive rows.
std::string write_rows_with_oiio(const StoredShape& shape, const RowsOf& rows,
                                 const std::string& format, int file);

}  // namespace lancer::io
