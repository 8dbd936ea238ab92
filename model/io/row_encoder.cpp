#include "model/io/row_encoder.h"

#include <algorithm>
#include <cstring>
#include <type_traits>

namespace lancer::io {
namespace {

StoredShape shape_to_store(const Image& image, const std::string& format,
                           const ImageWriteOptions& options) {
    StoredShape shape;
    shape.width = image.width;
    shape.height = image.height;
    const int color = image.color_channels();
    if (format == "openexr") {
        shape.channels = image.channels;
        shape.extra_names = image.extra_names;
        shape.notes = options.notes;
        shape.premultiplied = color == 4;
    } else {
        shape.channels = format == "tiff" ? color : std::min(color, 3);
        if (format == "hdr") shape.channels = 3;  // RGBE has only these
    }
    const bool whole = format == "tiff" || format == "jpeg";
    shape.type = !whole                                   ? SampleType::float32
                 : format == "tiff" && options.bits == 16 ? SampleType::uint16
                                                          : SampleType::uint8;
    return shape;
}

}  // namespace

RowEncoder::RowEncoder(const Image& image, const std::string& format,
                       const ImageWriteOptions& options)
    : shape_(shape_to_store(image, format, options)),
      channels_(image.channels),
      color_(image.color_channels()),
      last_(std::min(shape_.channels, format == "hdr" ? std::min(color_, 3) : image.channels) - 1),
      is_radiance_(format == "hdr"),
      quantizer_(shape_.type == SampleType::uint8 ? 8 : 16, options.linear) {}

template <class Value>
void RowEncoder::store(const double* pixel, std::string& bytes) const {
    const std::size_t begin = bytes.size();
    bytes.resize(begin + shape_.row_bytes());
    char* out = bytes.data() + begin;
    for (int x = 0; x < shape_.width; ++x, pixel += channels_) {
        for (int c = 0; c < shape_.channels; ++c, out += sizeof(Value)) {
            double value = pixel[std::min(c, last_)];
            if constexpr (std::is_integral_v<Value>) {
                const bool alpha = c == 3 && color_ == 4;
                value = alpha ? quantizer_.raw(value) : quantizer_.encoded(value);
            } else if (shape_.premultiplied && c < 3) {
                value *= pixel[3];
            } else if (is_radiance_) {
                constexpr double most = 1e38;  // 2^127 is 1.7e38
                value = value > 0 ? std::min(value, most) : 0;
            }
            // IEEE 754 rounds a double that is too large for a float to infinity.
            const auto stored = static_cast<Value>(value);
            std::memcpy(out, &stored, sizeof stored);
        }
    }
}

void RowEncoder::encode(const double* pixels, std::string& bytes) const {
    switch (shape_.type) {
        case SampleType::uint8:
            return store<std::uint8_t>(pixels, bytes);
        case SampleType::uint16:
            return store<std::uint16_t>(pixels, bytes);
        default:
            return store<float>(pixels, bytes);
    }
}

}  // namespace lancer::io
