#include "model/io/row_file.h"

#include <fcntl.h>
#include <fmt/format.h>

#include <cerrno>
#include <vector>

#include "model/io/descriptor.h"
#include "model/io/file.h"
#include "model/io/image_module.h"
#include "model/io/picture_format.h"
#include "model/io/png_file.h"
#include "model/io/ppm_file.h"
#include "model/io/row_encoder.h"

namespace lancer::io {
namespace {

/// Consecutive bytes, written in larger pieces.
class FileEnd {
  public:
    FileEnd(int file, const std::string& path) : file_(file), path_(path) {}
    void add(std::string_view bytes) {
        waiting_ += bytes;
        if (waiting_.size() > most_waiting) flush();
    }
    void flush() {
        write_all_at(file_, waiting_, at_, path_);
        at_ += waiting_.size();
        waiting_.clear();
    }

  private:
    static constexpr std::size_t most_waiting = std::size_t(1) << 20;
    int file_;
    const std::string& path_;
    std::string waiting_;
    std::uint64_t at_ = 0;
};

void write_plain(const std::string& format, const StoredShape& shape,
                 const ImageWriteOptions& options, const RowOf& row, int file,
                 const std::string& path) {
    FileEnd end(file, path);
    const auto add = [&end](std::string_view bytes) { end.add(bytes); };
    if (format == "png") {
        encode_png(shape, options, path, row, add);
    } else {
        encode_ppm(shape, row, add);
    }
    end.flush();
}

void write_by_library(const std::string& format, const StoredShape& shape, const RowOf& row,
                      int file, const std::string& path) {
    std::string rows;
    const RowsOf encoded = [&](int first, int count) -> const void* {
        rows.clear();
        for (int y = first; y < first + count; ++y) rows.append(row(y), shape.row_bytes());
        return rows.data();
    };
    const std::string problem = image_module().write_rows(shape, encoded, format, file);
    if (!problem.empty()) throw FileError(fmt::format("cannot write '{}': {}", path, problem));
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
    write_atomically(path, [&](const std::string& temporary) {
        const Descriptor file(open(temporary.c_str(), O_WRONLY | O_CLOEXEC));
        if (file.number() < 0) throw system_error("cannot write", path, errno);
        const bool is_plain = format == "png" || format == "ppm";
        if (is_plain)
            write_plain(format, encoder.shape(), options, row, file.number(), path);
        else
            write_by_library(format, encoder.shape(), row, file.number(), path);
    });
}

}  // namespace lancer::io
