// Converts linear light to the samples that a format stores.
#pragma once

#include <string>

#include "model/image.h"
#include "model/io/image_file.h"
#include "model/io/quantize.h"
#include "model/io/row_functions.h"
#include "model/io/stored_image.h"

namespace lancer::io {

class RowEncoder {
  public:
    /// For pictures of the same form as `like`, whose pixels are not used. `format` is that of
    /// format_of_name().
    RowEncoder(const Image& like, const std::string& format, const ImageWriteOptions& options);

    const StoredShape& shape() const { return shape_; }
    /// Stores shape().pixel_bytes() for each of `count` pixels, which are as in Image. 16 bits have
    /// their high byte first in PNG and PPM; for the picture process they are the machine's.
    void encode(const double* pixels, int count, char* out) const;

  private:
    template <class Value>
    void store(const double* pixels, int count, char* out) const;

    StoredShape shape_;
    int channels_;  ///< of the picture
    int color_;
    int last_;  ///< the channel whose values the further channels repeat
    bool is_radiance_;
    bool swaps_bytes_;
    Quantizer quantizer_;
};

/// The rows of an image. Both must stay alive.
RowOf encoded_rows(const RowEncoder& encoder, const Image& image);

}  // namespace lancer::io
