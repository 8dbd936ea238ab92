// A picture that arrives in tiles and is kept as its file stores it, in less memory than an Image.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "model/image.h"
#include "model/io/image_file.h"
#include "model/io/origin.h"
#include "model/io/row_encoder.h"

namespace lancer::io {

class TiledPicture {
  public:
    /// For a picture of the same form as `like`, whose pixels are not used, in the format of the
    /// name's ending.
    TiledPicture(const std::string& path, const Image& like, const ImageWriteOptions& options,
                 const std::optional<Origin>& origin);

    /// Puts a tile at column x, row y. Several threads may put different tiles at once.
    void put(int x, int y, const Image& tile);

    /// Writes the file as write_image() does, with its origin if there is one. All tiles must have
    /// been put. Throws FileError.
    void write() const;

  private:
    std::string path_;
    std::optional<Origin> origin_;
    ImageWriteOptions options_;
    RowEncoder encoder_;
    /// Not initialised, so that each thread is the first to touch the memory of its tiles.
    std::unique_ptr<char[]> samples_;
};

}  // namespace lancer::io
