#include "model/io/module/tiff.h"

#include <fmt/format.h>

#include <tiffio.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>

#include "model/diagnostic.h"
#include "model/io/byte_reader.h"
#include "model/io/image_limits.h"
#include "model/io/module/tiff_memory.h"
#include "model/io/module/tiff_samples.h"

namespace lancer::io {
namespace {

// ---- Messages of libtiff ----

/// The last message of libtiff, if any; while pixels are decoded, any message means damage.
struct Said {
    std::string text;
    bool decoding = false;
};
Said said;  // a process reads one picture

std::string formatted(const char* format, va_list arguments) {
    char text[512];
    std::vsnprintf(text, sizeof text, format, arguments);
    return text;
}

void hear_error(const char*, const char* format, va_list arguments) {
    if (said.text.empty()) said.text = formatted(format, arguments);
}

/// While decoding, libtiff warns about pixels that it invented.
void hear_warning(const char*, const char* format, va_list arguments) {
    if (!said.decoding || !said.text.empty()) return;
    const std::string text = formatted(format, arguments);
    if (text.starts_with("Old-style LZW")) return;
    said.text = text;
}

/// Throws with libtiff's message, or with `otherwise` when there is none.
[[noreturn]] void fail(const std::string& otherwise) {
    throw TiffError(said.text.empty() ? otherwise : said.text);
}

// ---- The picture's structure ----

template <class Value>
Value field(TIFF* file, std::uint32_t tag, Value otherwise) {
    Value value{};
    return TIFFGetFieldDefaulted(file, tag, &value) == 1 ? value : otherwise;
}

TiffLayout layout_of(TIFF* file) {
    TiffLayout layout;
    layout.width = field<std::uint32_t>(file, TIFFTAG_IMAGEWIDTH, 0);
    layout.height = field<std::uint32_t>(file, TIFFTAG_IMAGELENGTH, 0);
    layout.samples = field<std::uint16_t>(file, TIFFTAG_SAMPLESPERPIXEL, 1);
    layout.bits = field<std::uint16_t>(file, TIFFTAG_BITSPERSAMPLE, 1);
    layout.format = field<std::uint16_t>(file, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT);
    const std::uint16_t usual = layout.samples >= 3 ? PHOTOMETRIC_RGB : PHOTOMETRIC_MINISBLACK;
    if (TIFFGetField(file, TIFFTAG_PHOTOMETRIC, &layout.photometric) != 1)
        layout.photometric = usual;
    layout.separate = field<std::uint16_t>(file, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG) ==
                          PLANARCONFIG_SEPARATE &&
                      layout.samples > 1;
    const auto orientation = field<std::uint16_t>(file, TIFFTAG_ORIENTATION, 1);
    layout.orientation = orientation >= 1 && orientation <= 8 ? orientation : 1;
    std::uint16_t count = 0;
    std::uint16_t* kinds = nullptr;
    if (TIFFGetField(file, TIFFTAG_EXTRASAMPLES, &count, &kinds) == 1)
        layout.extra.assign(kinds, kinds + count);
    if (field<std::uint32_t>(file, TIFFTAG_IMAGEDEPTH, 1) > 1)
        throw TiffError("volume images are not supported");
    std::string excess = size_problem(layout.width, layout.height, layout.samples);
    if (!excess.empty()) throw TiffError(excess);
    return layout;
}

/// libtiff reads no byte after the end of the file, but some of its decoders fill in what is
/// missing.
void check_extents(TIFF* file, std::size_t file_size) {
    const bool tiled = TIFFIsTiled(file) != 0;
    const char* what = tiled ? "tile" : "strip";
    const std::uint32_t count = tiled ? TIFFNumberOfTiles(file) : TIFFNumberOfStrips(file);
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint64_t begin = TIFFGetStrileOffset(file, i);
        const std::uint64_t size = TIFFGetStrileByteCount(file, i);
        if (begin == 0 || size == 0)
            fail(fmt::format("{} {} of {} is missing", what, i + 1, count));
        if (begin > file_size || size > file_size - begin) {
            throw TiffError(fmt::format(
                "the file is truncated: {} {} of {} ends at byte {}, the file at byte {}", what,
                i + 1, count, begin + size, file_size));
        }
    }
}

/// Strips and tiles are decoded as a whole, and a small file may claim any size for them.
void check_strip_size(TIFF* file, const TiffLayout& layout) {
    std::uint64_t columns = layout.width;
    std::uint64_t rows = field<std::uint32_t>(file, TIFFTAG_ROWSPERSTRIP, layout.height);
    rows = std::min<std::uint64_t>(rows, layout.height);
    const bool tiled = TIFFIsTiled(file) != 0;
    if (tiled) {
        const auto width = field<std::uint32_t>(file, TIFFTAG_TILEWIDTH, 0);
        rows = field<std::uint32_t>(file, TIFFTAG_TILELENGTH, 0);
        if (width > longest_side || rows > longest_side) {
            throw TiffError(
                fmt::format("tiles of {} x {} pixels: a side is longer than the {} allowed", width,
                            rows, longest_side));
        }
        columns += width;  // a tile, and the rows of the picture that a row of tiles covers
    }
    // At most 2^18 x 2^17 pixels of 64 samples of 2^16 bits, so no overflow.
    const std::uint64_t bytes = (columns * layout.samples * layout.bits + 7) / 8 * rows;
    if (bytes > most_strip_bytes) {
        throw TiffError(fmt::format("{} of {} MiB: larger than the {} MiB that can be read at once",
                                    tiled ? "a row of tiles" : "a strip", bytes >> 20,
                                    most_strip_bytes >> 20));
    }
}

// ---- Pixels from libtiff ----

/// The raw rows of one plane: all samples of a pixel, or only one of them.
struct Plane {
    std::unique_ptr<unsigned char[]> bytes;
    std::size_t row_bytes = 0;
};

/// Reads bands of rows: a strip, or a row of tiles.
class Bands {
  public:
    Bands(TIFF* file, const TiffLayout& layout)
        : file_(file),
          layout_(layout),
          tiled_(TIFFIsTiled(file) != 0),
          planes_(layout.separate ? layout.samples : 1u) {
        if (tiled_) {
            tile_width_ = field<std::uint32_t>(file, TIFFTAG_TILEWIDTH, 0);
            rows_ = field<std::uint32_t>(file, TIFFTAG_TILELENGTH, 0);
        } else {
            rows_ = field<std::uint32_t>(file, TIFFTAG_ROWSPERSTRIP, layout.height);
            rows_ = std::clamp<std::uint32_t>(rows_, 1, layout.height);
        }
        if (rows_ == 0 || (tiled_ && tile_width_ == 0)) fail("it has tiles without pixels");
        const std::size_t bits = std::size_t{layout.bits} * (layout.separate ? 1 : layout.samples);
        row_bytes_ = (layout.width * bits + 7) / 8;
        for (std::size_t i = 0; i < planes_; ++i) {
            Plane plane;
            plane.row_bytes = row_bytes_;
            plane.bytes = std::make_unique_for_overwrite<unsigned char[]>(row_bytes_ * rows_);
            band_.push_back(std::move(plane));
        }
        if (tiled_) {
            tile_row_bytes_ = static_cast<std::size_t>(TIFFTileRowSize(file));
            pixel_bits_ = bits;
            // Tiles begin at whole bytes, because their widths are multiples of 16 (TIFF 6.0, page
            // 67).
            if (tile_width_ % 8 != 0 && bits % 8 != 0) fail("tiles of an odd width");
            if (tile_row_bytes_ != (tile_width_ * bits + 7) / 8) fail("tiles of an unknown form");
            tile_ = std::make_unique_for_overwrite<unsigned char[]>(tile_row_bytes_ * rows_);
        }
    }

    std::uint32_t rows() const { return rows_; }

    /// The rows from `y` on, at most rows() of them.
    const std::vector<Plane>& read(std::uint32_t y) {
        const std::uint32_t count = std::min(rows_, layout_.height - y);
        said.decoding = true;
        for (std::size_t plane = 0; plane < planes_; ++plane) {
            if (tiled_) {
                read_tiles(y, count, plane);
            } else {
                read_strip(y, count, plane);
            }
        }
        said.decoding = false;
        return band_;
    }

  private:
    void read_strip(std::uint32_t y, std::uint32_t count, std::size_t plane) {
        const std::uint32_t strip = TIFFComputeStrip(file_, y, static_cast<std::uint16_t>(plane));
        const auto size = static_cast<tmsize_t>(row_bytes_ * count);
        const tmsize_t got = TIFFReadEncodedStrip(file_, strip, band_[plane].bytes.get(), size);
        if (got != size || !said.text.empty())
            fail(fmt::format("strip {} holds too few pixels", strip + 1));
    }

    void read_tiles(std::uint32_t y, std::uint32_t count, std::size_t plane) {
        const auto size = static_cast<tmsize_t>(tile_row_bytes_ * rows_);
        for (std::uint32_t x = 0; x < layout_.width; x += tile_width_) {
            const std::uint32_t tile =
                TIFFComputeTile(file_, x, y, 0, static_cast<std::uint16_t>(plane));
            const tmsize_t got = TIFFReadEncodedTile(file_, tile, tile_.get(), size);
            if (got != size || !said.text.empty())
                fail(fmt::format("tile {} holds too few pixels", tile + 1));
            const std::size_t first = x * pixel_bits_ / 8;
            const std::size_t kept = std::min(tile_row_bytes_, row_bytes_ - first);
            for (std::size_t row = 0; row < count; ++row) {
                std::memcpy(band_[plane].bytes.get() + row * row_bytes_ + first,
                            tile_.get() + row * tile_row_bytes_, kept);
            }
        }
    }

    TIFF* file_;
    const TiffLayout& layout_;
    bool tiled_;
    std::size_t planes_;
    std::uint32_t rows_ = 0;  ///< of a band
    std::uint32_t tile_width_ = 0;
    std::size_t row_bytes_ = 0;  ///< of the picture, in one plane
    std::size_t tile_row_bytes_ = 0;
    std::size_t pixel_bits_ = 0;  ///< in one plane
    std::vector<Plane> band_;
    std::unique_ptr<unsigned char[]> tile_;
};

template <class Value>
void read_samples(TIFF* file, const TiffLayout& layout, const TiffColors& colors,
                  PictureSink& sink) {
    Bands bands(file, layout);
    const std::size_t width = layout.width;
    std::vector<Value> row(width * layout.samples);
    std::vector<Value> out(width * static_cast<std::size_t>(colors.shape.channels));
    for (std::uint32_t y = 0; y < layout.height; y += bands.rows()) {
        const std::vector<Plane>& planes = bands.read(y);
        const std::uint32_t count = std::min(bands.rows(), layout.height - y);
        for (std::uint32_t i = 0; i < count; ++i) {
            for (std::size_t plane = 0; plane < planes.size(); ++plane) {
                const std::size_t samples = layout.separate ? width : width * layout.samples;
                unpack_samples(planes[plane].bytes.get() + i * planes[plane].row_bytes, samples,
                               layout, row.data() + plane, planes.size());
            }
            arrange_samples(row.data(), layout, colors, out.data());
            sink.bytes(out.data(), out.size() * sizeof(Value));
        }
    }
}

/// Reads formats that only libtiff can convert, to 8-bit RGB.
void read_converted(TIFF* file, const TiffLayout& layout, PictureSink& sink) {
    if (layout.samples != 3 || layout.bits != 8)
        throw TiffError("YCbCr and Lab are read as three samples of 8 bits only");
    TIFFRGBAImage image;
    char reason[1024] = "";
    said.decoding = true;
    if (TIFFRGBAImageBegin(&image, file, 1, reason) != 1) throw TiffError(reason);
    image.req_orientation = image.orientation;  // the rows in the order of the file
    const std::size_t pixels = std::size_t{layout.width} * layout.height;
    const auto raster = std::make_unique<std::uint32_t[]>(pixels);
    const int got = TIFFRGBAImageGet(&image, raster.get(), layout.width, layout.height);
    TIFFRGBAImageEnd(&image);
    said.decoding = false;
    if (got != 1 || !said.text.empty()) fail("it cannot be converted to RGB");
    StoredShape shape;
    shape.width = static_cast<int>(layout.width);
    shape.height = static_cast<int>(layout.height);
    shape.channels = 3;
    shape.orientation = layout.orientation;
    sink.shape(shape);
    std::vector<unsigned char> row(shape.row_bytes());
    for (std::size_t y = 0; y < layout.height; ++y) {
        const std::uint32_t* in = raster.get() + y * layout.width;
        for (std::size_t x = 0; x < layout.width; ++x) {
            row[3 * x] = static_cast<unsigned char>(TIFFGetR(in[x]));
            row[3 * x + 1] = static_cast<unsigned char>(TIFFGetG(in[x]));
            row[3 * x + 2] = static_cast<unsigned char>(TIFFGetB(in[x]));
        }
        sink.bytes(row.data(), row.size());
    }
}

void read_file(TIFF* file, std::size_t file_size, PictureSink& sink) {
    TiffLayout layout = layout_of(file);
    check_extents(file, file_size);
    check_strip_size(file, layout);
    const auto compression = field<std::uint16_t>(file, TIFFTAG_COMPRESSION, COMPRESSION_NONE);
    if (TIFFIsCODECConfigured(compression) == 0)
        throw TiffError(fmt::format("its compression ({}) is not supported", compression));
    if (layout.photometric == PHOTOMETRIC_YCBCR && compression == COMPRESSION_JPEG) {
        TIFFSetField(file, TIFFTAG_JPEGCOLORMODE, JPEGCOLORMODE_RGB);
        layout.photometric = PHOTOMETRIC_RGB;
    }
    switch (layout.photometric) {
        case PHOTOMETRIC_YCBCR:
        case PHOTOMETRIC_CIELAB:
        case PHOTOMETRIC_ICCLAB:
        case PHOTOMETRIC_ITULAB:
            read_converted(file, layout, sink);
            return;
        default:
            break;
    }
    TiffColors colors = colors_of(layout);
    if (layout.photometric == PHOTOMETRIC_PALETTE) {
        std::uint16_t* palette[3] = {};
        if (TIFFGetField(file, TIFFTAG_COLORMAP, &palette[0], &palette[1], &palette[2]) != 1)
            fail("its palette is missing");
        set_palette(colors, palette, std::size_t{1} << layout.bits);
    }
    if (layout.photometric == PHOTOMETRIC_SEPARATED &&
        field<std::uint16_t>(file, TIFFTAG_INKSET, INKSET_CMYK) != INKSET_CMYK) {
        throw TiffError("inks other than cyan, magenta, yellow and black are not supported");
    }
    sink.shape(colors.shape);
    switch (colors.shape.type) {
        case SampleType::uint8:
            return read_samples<std::uint8_t>(file, layout, colors, sink);
        case SampleType::uint16:
            return read_samples<std::uint16_t>(file, layout, colors, sink);
        case SampleType::float32:
            return read_samples<float>(file, layout, colors, sink);
        case SampleType::float64:
            return read_samples<double>(file, layout, colors, sink);
    }
}

/// For a file that libtiff cannot open. Most files have their directory at the end, and libtiff's
/// message then only mentions the directory.
bool ends_before_its_directory(std::string_view bytes) {
    const auto order = bytes.starts_with("MM") ? std::endian::big : std::endian::little;
    try {
        ByteReader header(bytes.substr(std::min<std::size_t>(4, bytes.size())), "", order);
        return header.read<std::uint32_t>() >= bytes.size();
    } catch (const FileError&) {
        return true;
    }
}

}  // namespace

std::string read_tiff(std::string_view bytes, PictureSink& sink) {
    said = {};
    TIFFSetErrorHandler(hear_error);
    TIFFSetWarningHandler(hear_warning);
    TiffMemory memory{bytes};
    const std::unique_ptr<TIFF, TiffCloser> file = open_in_memory(memory);
    try {
        if (file == nullptr && ends_before_its_directory(bytes))
            throw TiffError("the file is truncated");
        if (file == nullptr) fail("it is not a TIFF file");
        read_file(file.get(), bytes.size(), sink);
    } catch (const TiffError& error) {
        return error.what();
    }
    return {};
}

}  // namespace lancer::io
