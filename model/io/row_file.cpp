#include "model/io/row_file.h"

#include <fcntl.h>
#include <fmt/format.h>

#include <cerrno>
#include <vector>

#include "model/io/descriptor.h"
#include "model/io/file.h"
#include "model/io/image_module.h"
#include "model/io/picture_format.h"
#include "model/io/row_encoder.h"

namespace lancer::io {
namespace {

void write_by_library(const std::string& path, const StoredShape& shape, const RowOf& row) {
    std::string rows;
    const RowsOf encoded = [&](int first, int count) -> const void* {
        rows.clear();
        for (int y = first; y < first + count; ++y) rows.append(row(y), shape.row_bytes());
        return rows.data();
    };
    write_atomically(path, [&](const std::string& temporary) {
        const Descriptor file(open(temporary.c_str(), O_WRONLY | O_CLOEXEC));
        if (file.number() < 0) throw system_error("cannot write", path, errno);
        const std::string problem =
            image_module().write_rows(shape, encoded, format_of_name(path), file.number());
        if (!problem.empty()) throw FileError(fmt::format("cannot write '{}': {}", path, problem));
    });
}

}  // namespace

void write_rows(const std::string& path, const Image& like, const ImageWriteOptions& options,
                const NextRow& next) {
    const std::string format = format_of_name(path);
    std::vector<double> pixels(static_cast<std::size_t>(like.width) *
                               static_cast<std::size_t>(like.channels));
    const RowEncoder encoder(like, format, options);
    std::string samples(encoder.shape().row_bytes(), '\0');
    const RowOf row = [&](int) {
        next(pixels.data());
        encoder.encode(pixels.data(), like.width, samples.data());
        return samples.data();
    };
    if (format == "png" || format == "ppm")
        write_image(path, encoder.shape(), row, options);
    else
        write_by_library(path, encoder.shape(), row);
}

}  // namespace lancer::io
