#include "model/io/tiled_picture.h"

#include "model/io/file.h"
#include "model/io/picture_format.h"

namespace lancer::io {

TiledPicture::TiledPicture(const std::string& path, const Image& like,
                           const ImageWriteOptions& options, const std::optional<Origin>& origin)
    : path_(path),
      origin_(origin),
      options_(origin ? options_with_origin(options, path, *origin) : options),
      encoder_(like, format_of_name(path), options_),
      samples_(std::make_unique_for_overwrite<char[]>(
          encoder_.shape().row_bytes() * static_cast<std::size_t>(encoder_.shape().height))) {}

void TiledPicture::put(int x, int y, const Image& tile) {
    const StoredShape& shape = encoder_.shape();
    char* to = samples_.get() + static_cast<std::size_t>(y) * shape.row_bytes() +
               static_cast<std::size_t>(x) * shape.pixel_bytes();
    for (int row = 0; row < tile.height; ++row, to += shape.row_bytes())
        encoder_.encode(tile.pixel(0, row), tile.width, to);
}

void TiledPicture::write() const {
    const StoredShape& shape = encoder_.shape();
    const RowOf row = [&](int y) {
        return samples_.get() + static_cast<std::size_t>(y) * shape.row_bytes();
    };
    if (origin_)
        write_file(path_, with_origin(encode_image(path_, shape, row, options_), *origin_));
    else
        write_image(path_, shape, row, options_);
}

}  // namespace lancer::io
