#include "model/io/module/tiff_samples.h"

#include <fmt/format.h>

#include <tiff.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

#include "model/io/module/cmyk.h"

namespace lancer::io {
namespace {

/// IEEE 754 binary16.
float from_half(std::uint16_t bits) {
    const int exponent = bits >> 10 & 31;
    const auto fraction = static_cast<float>(bits & 1023);
    float value = 0;
    if (exponent == 31) {
        value = fraction == 0 ? std::numeric_limits<float>::infinity()
                              : std::numeric_limits<float>::quiet_NaN();
    } else if (exponent == 0) {
        value = std::ldexp(fraction, -24);
    } else {
        value = std::ldexp(1024 + fraction, exponent - 25);
    }
    return (bits & 0x8000) != 0 ? -value : value;
}

template <class Number>
Number number_at(const unsigned char* raw, std::size_t index) {
    Number number;
    std::memcpy(&number, raw + index * sizeof number, sizeof number);
    return number;
}

/// Unpacks integers of up to 16 bits, the highest bit first.
template <class Value>
void unpack_bits(const unsigned char* raw, std::size_t count, int bits, bool scaled, Value* out,
                 std::size_t stride) {
    constexpr std::uint32_t top = std::numeric_limits<Value>::max();
    const std::uint32_t highest = (1u << bits) - 1;
    std::uint32_t pending = 0;
    int have = 0;
    for (std::size_t i = 0; i < count; ++i) {
        while (have < bits) {
            pending = pending << 8 | *raw++;
            have += 8;
        }
        have -= bits;
        const std::uint32_t value = pending >> have & highest;
        out[i * stride] =
            static_cast<Value>(scaled ? (value * top + highest / 2) / highest : value);
    }
}

SampleType type_of(const TiffLayout& layout) {
    const int bits = layout.bits;
    if (layout.photometric == PHOTOMETRIC_PALETTE) return SampleType::uint16;
    switch (layout.format) {
        case SAMPLEFORMAT_UINT:
        case SAMPLEFORMAT_VOID:
            if (bits >= 1 && bits <= 8) return SampleType::uint8;
            if (bits > 8 && bits <= 16) return SampleType::uint16;
            if (bits == 32) return SampleType::float32;
            break;
        case SAMPLEFORMAT_INT:
            if (bits == 8 || bits == 16 || bits == 32) return SampleType::float32;
            break;
        case SAMPLEFORMAT_IEEEFP:
            if (bits == 16 || bits == 32) return SampleType::float32;
            if (bits == 64) return SampleType::float64;
            break;
        default:
            break;
    }
    throw TiffError(fmt::format("samples of {} bits (sample format {}) are not supported", bits,
                                layout.format));
}

/// The number of colour samples, before and after conversion to RGB or grey.
struct ColorSamples {
    std::size_t stored;
    std::size_t converted;
};

ColorSamples color_samples(const TiffLayout& layout, SampleType type) {
    switch (layout.photometric) {
        case PHOTOMETRIC_MINISBLACK:
        case PHOTOMETRIC_MINISWHITE:
        case PHOTOMETRIC_MASK:
            return {1, 1};
        case PHOTOMETRIC_RGB:
            return {3, 3};
        case PHOTOMETRIC_PALETTE:
            if (layout.samples != 1 || layout.bits > 16 || layout.format == SAMPLEFORMAT_IEEEFP)
                throw TiffError("a palette needs exactly one sample per pixel");
            return {1, 3};
        case PHOTOMETRIC_SEPARATED:
            if (type != SampleType::uint8 && type != SampleType::uint16)
                throw TiffError("CMYK is read as whole numbers of up to 16 bits only");
            return {4, 3};
        default:
            throw TiffError(
                fmt::format("its kind of colours (photometric interpretation {}) is not supported",
                            layout.photometric));
    }
}

}  // namespace

TiffColors colors_of(const TiffLayout& layout) {
    TiffColors colors;
    StoredShape& shape = colors.shape;
    shape.width = static_cast<int>(layout.width);
    shape.height = static_cast<int>(layout.height);
    shape.type = type_of(layout);
    shape.orientation = layout.orientation;
    const ColorSamples color = color_samples(layout, shape.type);
    if (layout.samples < color.stored) throw TiffError("it has too few samples for a colour");

    const std::size_t extra = layout.samples - color.stored;
    std::size_t alpha = extra;  // none
    for (std::size_t i = std::min(extra, layout.extra.size()); i-- > 0;) {
        const bool associated = layout.extra[i] == EXTRASAMPLE_ASSOCALPHA;
        if (!associated && layout.extra[i] != EXTRASAMPLE_UNASSALPHA) continue;
        alpha = i;
        shape.premultiplied = associated;
    }
    // Old files have a fourth sample without declaring its meaning.
    if (layout.extra.empty() && extra == 1 && layout.photometric == PHOTOMETRIC_RGB) {
        alpha = 0;
        shape.premultiplied = true;
    }
    for (std::size_t c = 0; c < color.converted; ++c) colors.order.push_back(c);
    if (alpha < extra) {
        colors.order.resize(3, 0);  // beside alpha, grey is stored three times
        for (std::size_t c = 0; c < color.converted; ++c) colors.order[c] = c;
        colors.order.push_back(color.converted + alpha);
    }
    for (std::size_t i = 0; i < extra; ++i) {
        if (i == alpha) continue;
        colors.order.push_back(color.converted + i);
        shape.extra_names.push_back(fmt::format("channel{}", color.stored + i));
    }
    shape.channels = static_cast<int>(colors.order.size());
    return colors;
}

void set_palette(TiffColors& colors, std::uint16_t* const planes[3], std::size_t count) {
    bool eight_bits = true;
    for (int c = 0; c < 3; ++c)
        eight_bits &= std::all_of(planes[c], planes[c] + count, [](auto v) { return v < 256; });
    const int factor = eight_bits ? 257 : 1;
    for (std::size_t i = 0; i < count; ++i) {
        std::array<std::uint16_t, 3> color{};
        for (std::size_t c = 0; c < 3; ++c)
            color[c] = static_cast<std::uint16_t>(planes[c][i] * factor);
        colors.palette.push_back(color);
    }
}

template <class Value>
void unpack_samples(const unsigned char* raw, std::size_t count, const TiffLayout& layout,
                    Value* out, std::size_t stride) {
    if constexpr (std::is_integral_v<Value>) {
        if (layout.bits == 8 * sizeof(Value) && stride == 1) {
            std::memcpy(out, raw, count * sizeof(Value));
        } else if (layout.bits == 16) {
            for (std::size_t i = 0; i < count; ++i)
                out[i * stride] = static_cast<Value>(number_at<std::uint16_t>(raw, i));
        } else {
            unpack_bits(raw, count, layout.bits, layout.photometric != PHOTOMETRIC_PALETTE, out,
                        stride);
        }
    } else {
        const auto fill = [&](auto value_at) {
            for (std::size_t i = 0; i < count; ++i)
                out[i * stride] = static_cast<Value>(value_at(i));
        };
        const auto fraction = [&]<class Number>(Number) {
            fill([raw](std::size_t i) {
                return static_cast<double>(number_at<Number>(raw, i)) /
                       static_cast<double>(std::numeric_limits<Number>::max());
            });
        };
        const bool is_float = layout.format == SAMPLEFORMAT_IEEEFP;
        const bool is_signed = layout.format == SAMPLEFORMAT_INT;
        if (is_float && layout.bits == 16) {
            fill([raw](std::size_t i) { return from_half(number_at<std::uint16_t>(raw, i)); });
        } else if (is_float && layout.bits == 32) {
            fill([raw](std::size_t i) { return number_at<float>(raw, i); });
        } else if (is_float) {
            fill([raw](std::size_t i) { return number_at<double>(raw, i); });
        } else if (is_signed && layout.bits == 8) {
            fraction(std::int8_t{});
        } else if (is_signed && layout.bits == 16) {
            fraction(std::int16_t{});
        } else if (is_signed) {
            fraction(std::int32_t{});
        } else {
            fraction(std::uint32_t{});
        }
    }
}

template <class Value>
void arrange_samples(Value* row, const TiffLayout& layout, const TiffColors& colors, Value* out) {
    const std::size_t samples = layout.samples;
    for (std::size_t x = 0; x < layout.width; ++x) {
        Value* in = row + x * samples;
        std::array<Value, 3> palette_color{};
        if (layout.photometric == PHOTOMETRIC_PALETTE) {
            if constexpr (std::is_integral_v<Value>) {
                for (std::size_t c = 0; c < 3; ++c)
                    palette_color[c] = static_cast<Value>(colors.palette[in[0]][c]);
                in = palette_color.data();
            }
        } else if (layout.photometric == PHOTOMETRIC_MINISWHITE) {
            const Value top =
                std::is_integral_v<Value> ? std::numeric_limits<Value>::max() : Value{1};
            in[0] = static_cast<Value>(top - in[0]);
        } else if (layout.photometric == PHOTOMETRIC_SEPARATED) {
            if constexpr (std::is_integral_v<Value>) {
                rgb_from_cmyk(in, 1);
                std::copy(in + 4, in + samples, in + 3);  // alpha, which now follows three samples
            }
        }
        for (const std::size_t sample : colors.order) *out++ = in[sample];
    }
}

#define LANCER_SAMPLES(Value)                                                                  \
    template void unpack_samples(const unsigned char*, std::size_t, const TiffLayout&, Value*, \
                                 std::size_t);                                                 \
    template void arrange_samples(Value*, const TiffLayout&, const TiffColors&, Value*);
LANCER_SAMPLES(std::uint8_t)
LANCER_SAMPLES(std::uint16_t)
LANCER_SAMPLES(float)
LANCER_SAMPLES(double)
#undef LANCER_SAMPLES

}  // namespace lancer::io
