// Converts a row of linear light to the samples that a format of the picture process stores.
#pragma once

#include <string>

#include "model/image.h"
#include "model/io/image_file.h"
#include "model/io/quantize.h"
#include "model/io/stored_image.h"

namespace lancer::io {

class RowEncoder {
  public:
    /// For pictures of the same form as `image`, whose pixels are not used.
    RowEncoder(const Image& image, const std::string& format, const ImageWriteOptions& options);

    const StoredShape& shape() const { return shape_; }
    /// Appends the row's shape().row_bytes() bytes; `pixels` as in Image.
    void encode(const double* pixels, std::string& bytes) const;

  private:
    template <class Value>
    void store(const double* pixels, std::string& bytes) const;

    StoredShape shape_;
    int channels_;  ///< of the picture
    int color_;
    int last_;  ///< the channel whose values the further channels repeat
    bool is_radiance_;
    Quantizer quantizer_;
};

}  // namespace lancer::io
