// From the samples of a TIFF file to channels: bits unpacked, palettes, inks and alpha sorted out.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "model/io/stored_image.h"

namespace lancer::io {

/// Why a TIFF file is not read.
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

/// How the samples become channels. Throws TiffError for combinations that have no meaning here.
TiffColors colors_of(const TiffLayout& layout);

/// Of `count` colours, in 16 bits as the specification has it, or in 8 as some programs do.
void set_palette(TiffColors& colors, std::uint16_t* const planes[3], std::size_t count);

/// `count` samples from the bits at `raw`, each `stride` after the last. Whole numbers are scaled
/// to all of Value, but for indices of a palette.
template <class Value>
void unpack_samples(const unsigned char* raw, std::size_t count, const TiffLayout& layout,
                    Value* out, std::size_t stride);

/// One row: the samples of each pixel into its channels. `row` is changed.
template <class Value>
void arrange_samples(Value* row, const TiffLayout& layout, const TiffColors& colors, Value* out);

}  // namespace lancer::io
