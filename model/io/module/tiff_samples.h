// Converts the samples of a TIFF file to channels: unpacks bits, resolves palettes, inks and alpha.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "model/io/stored_image.h"

namespace lancer::io {

/// The reason why a TIFF file is not read.
struct TiffError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Tags of the file (TIFF 6.0).
struct TiffLayout {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint16_t samples = 0;      ///< of a pixel
    std::uint16_t bits = 0;         ///< of a sample
    std::uint16_t format = 0;       ///< SAMPLEFORMAT_…
    std::uint16_t photometric = 0;  ///< PHOTOMETRIC_…
    bool separate = false;          ///< plane by plane
    int orientation = 1;
    std::vector<std::uint16_t> extra;  ///< EXTRASAMPLE_… of the samples beyond the colours
};

struct TiffColors {
    StoredShape shape;
    std::vector<std::size_t> order;  ///< samples, after conversion to RGB, in the order of channels
    std::vector<std::array<std::uint16_t, 3>> palette;
};

/// The mapping of samples to channels. Throws TiffError for unsupported combinations.
TiffColors colors_of(const TiffLayout& layout);

/// Sets a palette of `count` colours, in 16 bits as in the specification, or in 8 bits as some
/// programs write it.
void set_palette(TiffColors& colors, std::uint16_t* const planes[3], std::size_t count);

/// Unpacks `count` samples from the bits at `raw`, each `stride` after the previous one. Integers
/// are scaled to the full range of Value, except for palette indices.
template <class Value>
void unpack_samples(const unsigned char* raw, std::size_t count, const TiffLayout& layout,
                    Value* out, std::size_t stride);

/// Converts one row of samples to channels. `row` is changed.
template <class Value>
void arrange_samples(Value* row, const TiffLayout& layout, const TiffColors& colors, Value* out);

}  // namespace lancer::io
