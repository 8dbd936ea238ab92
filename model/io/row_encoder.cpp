#include "model/io/row_encoder.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <type_traits>

namespace lancer::io {
namespace {

StoredShape shape_to_store(const Image& like, const std::string& format,
                           const ImageWriteOptions& options) {
    StoredShape shape;
    shape.width = like.width;
    shape.height = like.height;
    const int color = like.color_channels();
    if (format == "openexr") {
        shape.channels = like.channels;
        shape.extra_names = like.extra_names;
        shape.notes = options.notes;
        shape.premultiplied = color == 4;
    } else if (format == "png") {
        shape.channels = color >= 4 ? 4 : color == 3 ? 3 : 1;
    } else if (format == "ppm" || format == "hdr") {
        shape.channels = 3;  // they have only these
    } else {
        shape.channels = format == "tiff" ? color : std::min(color, 3);
    }
    const bool floats = format == "openexr" || format == "hdr";
    const bool deep = format != "jpeg" && options.bits == 16;
    shape.type = floats ? SampleType::float32 : deep ? SampleType::uint16 : SampleType::uint8;
    return shape;
}

/// The last channel whose values are stored; further ones repeat them.
int last_channel(const Image& like, const std::string& format, int stored) {
    const int color = like.color_channels();
    if (format == "ppm") return color < 3 ? 0 : 2;
    return std::min(stored, format == "hdr" ? std::min(color, 3) : like.channels) - 1;
}

}  // namespace

RowEncoder::RowEncoder(const Image& like, const std::string& format,
                       const ImageWriteOptions& options)
    : shape_(shape_to_store(like, format, options)),
      channels_(like.channels),
      color_(like.color_channels()),
      last_(last_channel(like, format, shape_.channels)),
      is_radiance_(format == "hdr"),
      swaps_bytes_((format == "png" || format == "ppm") &&
                   std::endian::native == std::endian::little),
      quantizer_(shape_.type == SampleType::uint8 ? 8 : 16, options.linear) {}

template <class Value>
void RowEncoder::store(const double* pixel, int count, char* out) const {
    for (int x = 0; x < count; ++x, pixel += channels_) {
        for (int c = 0; c < shape_.channels; ++c, out += sizeof(Value)) {
            double value = pixel[std::min(c, last_)];
            if constexpr (std::is_integral_v<Value>) {
                const bool alpha = c == 3 && color_ == 4;
                unsigned step = alpha ? quantizer_.raw(value) : quantizer_.encoded(value);
                if (sizeof(Value) == 2 && swaps_bytes_) step = (step & 0xFF) << 8 | step >> 8;
                const auto stored = static_cast<Value>(step);
                std::memcpy(out, &stored, sizeof stored);
                continue;
            } else if (shape_.premultiplied && c < 3) {
                value *= pixel[3];
            } else if (is_radiance_) {
                constexpr double most = 1e38;  // 2^127 is 1.7e38
                value = value > 0 ? std::min(value, most) : 0;
            }
            // IEEE 754 rounds a double that is too large for a float to infinity.
            const auto stored = static_cast<float>(value);
            std::memcpy(out, &stored, sizeof stored);
        }
    }
}

void RowEncoder::encode(const double* pixels, int count, char* out) const {
    switch (shape_.type) {
        case SampleType::uint8:
            return store<std::uint8_t>(pixels, count, out);
        case SampleType::uint16:
            return store<std::uint16_t>(pixels, count, out);
        default:
            return store<float>(pixels, count, out);
    }
}

RowOf encoded_rows(const RowEncoder& encoder, const Image& image) {
    return [&encoder, &image, row = std::string(encoder.shape().row_bytes(), '\0')](int y) mutable {
        encoder.encode(image.pixel(0, y), image.width, row.data());
        return row.data();
    };
}

}  // namespace lancer::io
