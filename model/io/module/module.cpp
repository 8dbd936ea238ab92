// The module's table of functions. See image_module.h.
#include <exception>
#include <new>

#include "model/diagnostic.h"
#include "model/io/image_module.h"
#include "model/io/module/confine.h"
#include "model/io/module/jpeg.h"
#include "model/io/module/oiio.h"
#include "model/io/module/tiff.h"

namespace lancer::io {
namespace {

/// Runs `action` and converts failures of a library to text.
template <class Action>
std::string guarded(Action action) {
    try {
        std::string problem = action();
        return problem;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const FileError&) {
        throw;
    } catch (const std::exception& error) {
        return error.what();
    }
}

std::string read(std::string_view bytes, const std::string& format, PictureSink& sink) {
    return guarded([&] {
        if (format == "tiff") return read_tiff(bytes, sink);
        if (format == "jpeg") return read_jpeg(bytes, sink);
        return read_with_oiio(bytes, format, sink);
    });
}

std::string write(const StoredShape& shape, const void* pixels, const std::string& format,
                  PictureSink& sink) {
    return guarded([&] { return write_with_oiio(shape, pixels, format, sink); });
}

std::string write_rows(const StoredShape& shape, const RowsOf& rows, const std::string& format,
                       int file) {
    return guarded([&] { return write_rows_with_oiio(shape, rows, format, file); });
}

const ImageModule functions{read, write, write_rows, confine};

}  // namespace
}  // namespace lancer::io

const lancer::io::ImageModule* lancer_image_module() {
    lancer::io::warm_up_oiio();
    return &lancer::io::functions;
}
