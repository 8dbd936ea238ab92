// EXR and Radiance files read, and all formats written, by OpenImageIO.
#pragma once

#include <string>
#include <string_view>

#include "model/io/row_functions.h"
#include "model/io/stored_image.h"

namespace lancer::io {

/// What OpenImageIO makes anew for every process, made once for all of them.
void warm_up_oiio();

/// All return why they failed, empty when they did not.
std::string read_with_oiio(std::string_view bytes, const std::string& format, PictureSink& sink);
std::string write_with_oiio(const StoredShape& shape, const void* pixels, const std::string& format,
                            PictureSink& sink);
/// The same bytes into an open file, from rows that come one after the other.
std::string write_rows_with_oiio(const StoredShape& shape, const RowsOf& rows,
                                 const std::string& format, int file);

}  // namespace lancer::io
