#include "model/io/module/oiio.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "model/io/descriptor.h"
#include "model/io/image_limits.h"

namespace lancer::io {
namespace {

// ---- Reading ----

/// The mapping of the file's channels to ours: colour, alpha, then the others by name.
struct ChannelOrder {
    std::vector<std::size_t> channels;  ///< for grey with alpha, the grey channel three times
    std::vector<std::string> extra_names;
};

ChannelOrder channel_order(const OIIO::ImageSpec& spec) {
    ChannelOrder order;
    std::vector<bool> taken(static_cast<std::size_t>(spec.nchannels), false);
    const auto take = [&](int channel) {
        order.channels.push_back(static_cast<std::size_t>(channel));
        taken[static_cast<std::size_t>(channel)] = true;
    };
    const int red = spec.channelindex("R");
    const int green = spec.channelindex("G");
    const int blue = spec.channelindex("B");
    if (red >= 0 && green >= 0 && blue >= 0) {
        for (const int channel : {red, green, blue}) take(channel);
    } else {
        const int gray = spec.channelindex("Y");
        take(gray >= 0 ? gray : spec.alpha_channel == 0 && spec.nchannels > 1 ? 1 : 0);
    }
    if (spec.alpha_channel >= 0 && !taken[static_cast<std::size_t>(spec.alpha_channel)]) {
        if (order.channels.size() == 1) order.channels.resize(3, order.channels[0]);
        take(spec.alpha_channel);
    }
    for (int channel = 0; channel < spec.nchannels; ++channel) {
        if (taken[static_cast<std::size_t>(channel)]) continue;
        order.channels.push_back(static_cast<std::size_t>(channel));
        order.extra_names.push_back(spec.channel_name(channel));
    }
    return order;
}

bool in_file_order(const ChannelOrder& order) {
    for (std::size_t i = 0; i < order.channels.size(); ++i)
        if (order.channels[i] != i) return false;
    return true;
}

/// Enough rows to keep all threads of a decoder busy, but no more. So memory grows with the real
/// content of the file, not with the size that it claims.
int rows_at_once(const OIIO::ImageSpec& spec) {
    constexpr std::size_t bytes = std::size_t(32) << 20;
    const std::size_t row = static_cast<std::size_t>(spec.width) *
                            static_cast<std::size_t>(spec.nchannels) * sizeof(float);
    const int rows = static_cast<int>(std::clamp<std::size_t>(bytes / row, 1, 1024));
    const int block = spec.tile_height > 0 ? spec.tile_height : 256;  // of the largest in EXR
    return rows < block ? (spec.tile_height > 0 ? block : std::max(16, rows / 16 * 16))
                        : rows / block * block;
}

bool read_rows(OIIO::ImageInput& input, const OIIO::ImageSpec& spec, const ChannelOrder& order,
               PictureSink& sink) {
    const int step = rows_at_once(spec);
    const std::size_t width = static_cast<std::size_t>(spec.width);
    const std::size_t channels = static_cast<std::size_t>(spec.nchannels);
    const bool as_they_are = in_file_order(order);
    std::vector<float> rows(width * channels *
                            static_cast<std::size_t>(std::min(step, spec.height)));
    std::vector<float> sorted(as_they_are ? 0 : width * order.channels.size());
    for (int y = 0; y < spec.height; y += step) {
        const int begin = spec.y + y;
        const int end = spec.y + std::min(y + step, spec.height);
        const bool read =
            spec.tile_width > 0
                ? input.read_tiles(0, 0, spec.x, spec.x + spec.width, begin, end, spec.z,
                                   spec.z + 1, 0, spec.nchannels, OIIO::TypeFloat, rows.data())
                : input.read_scanlines(0, 0, begin, end, spec.z, 0, spec.nchannels, OIIO::TypeFloat,
                                       rows.data());
        if (!read) return false;
        const std::size_t count = static_cast<std::size_t>(end - begin);
        if (as_they_are) {
            sink.bytes(rows.data(), count * width * channels * sizeof(float));
            continue;
        }
        for (std::size_t row = 0; row < count; ++row) {
            const float* in = rows.data() + row * width * channels;
            float* out = sorted.data();
            for (std::size_t x = 0; x < width; ++x, in += channels)
                for (const std::size_t channel : order.channels) *out++ = in[channel];
            sink.bytes(sorted.data(), sorted.size() * sizeof(float));
        }
    }
    return true;
}

/// Radiance's size line, `-Y 480 +X 640`, follows an empty line. The first axis changes from
/// scanline to scanline; -Y runs from the top, +X from the left. OpenImageIO confuses two of the
/// eight orientations.
int radiance_orientation(std::string_view bytes) {
    const std::size_t empty = bytes.find("\n\n");
    if (empty == std::string_view::npos) return 1;
    const std::string_view line = bytes.substr(empty + 2, bytes.find('\n', empty + 2) - empty - 2);
    const std::size_t x = line.find('X');
    const std::size_t y = line.find('Y');
    if (x == std::string_view::npos || y == std::string_view::npos || x == 0 || y == 0) return 1;
    const bool from_right = line[x - 1] == '-';
    const bool from_bottom = line[y - 1] == '+';
    if (y < x) return from_bottom ? (from_right ? 3 : 4) : (from_right ? 2 : 1);
    return from_right ? (from_bottom ? 7 : 6) : (from_bottom ? 8 : 5);
}

// ---- Writing ----

OIIO::TypeDesc type_of(SampleType type) {
    switch (type) {
        case SampleType::uint8:
            return OIIO::TypeUInt8;
        case SampleType::uint16:
            return OIIO::TypeUInt16;
        case SampleType::float32:
            return OIIO::TypeFloat;
        case SampleType::float64:
            return OIIO::TypeDesc::DOUBLE;
    }
    return OIIO::TypeUnknown;
}

OIIO::ImageSpec spec_of(const StoredShape& shape, const std::string& format) {
    OIIO::ImageSpec spec(shape.width, shape.height, shape.channels, type_of(shape.type));
    const int color = shape.channels - static_cast<int>(shape.extra_names.size());
    spec.channelnames.clear();
    for (const char* name : {"R", "G", "B", "A"}) spec.channelnames.emplace_back(name);
    spec.channelnames.resize(static_cast<std::size_t>(color));
    if (color == 1) spec.channelnames = {"Y"};
    spec.channelnames.insert(spec.channelnames.end(), shape.extra_names.begin(),
                             shape.extra_names.end());
    spec.alpha_channel = color == 4 ? 3 : -1;
    if (!shape.premultiplied && color == 4) spec.attribute("oiio:UnassociatedAlpha", 1);
    if (format == "jpeg") {
        spec.attribute("compression", "jpeg:95");
        spec.attribute("jpeg:subsampling", "4:4:4");
    } else {
        spec.attribute("compression", "zip");
        // otherwise EXR stores the time of writing
        spec.attribute("DateTime", "1970:01:01 00:00:00");
    }
    for (const auto& [name, value] : shape.notes) spec.attribute("lancer:" + name, value);
    return spec;
}

/// Files in memory have no name; libraries use this one in their messages.
constexpr const char* nameless = "picture";

/// An open file in the form that OpenImageIO writes to.
class FileProxy : public OIIO::Filesystem::IOProxy {
  public:
    explicit FileProxy(int file) : IOProxy("", Write), file_(file) {}
    const char* proxytype() const override { return "descriptor"; }  // "file" has a FILE*
    std::size_t write(const void* bytes, std::size_t size) override {
        size = pwrite(bytes, size, m_pos);
        m_pos += static_cast<std::int64_t>(size);
        return size;
    }
    std::size_t pwrite(const void* bytes, std::size_t size, std::int64_t at) override {
        try {
            write_all_at(file_, {static_cast<const char*>(bytes), size},
                         static_cast<std::uint64_t>(at), nameless);
        } catch (const FileError& error) {  // exceptions must not pass through C libraries
            problem_ = error.what();
            return 0;
        }
        size_ = std::max(size_, at + static_cast<std::int64_t>(size));
        return size;
    }
    /// The reason of a failure; empty when there was none.
    const std::string& problem() const { return problem_; }
    std::size_t size() const override { return static_cast<std::size_t>(size_); }
    void flush() const override {}

  private:
    int file_;
    std::int64_t size_ = 0;
    std::string problem_;
};

/// The number of threads of OpenEXR: that of the processors.
int exr_threads = 1;

/// OpenImageIO's reason for a failure; never empty.
template <class Source>
std::string reason_of(Source& source) {
    std::string reason = source.geterror();
    return reason.empty() ? "OpenImageIO gives no reason" : reason;
}

}  // namespace

void warm_up_oiio() {
    // A forked process does not have the threads that are started here.
    OIIO::getattribute("exr_threads", exr_threads);
    OIIO::attribute("exr_threads", -1);
    for (const char* format : {"openexr", "hdr"}) OIIO::ImageInput::create(format);
    for (const char* format : {"openexr", "hdr", "tiff", "jpeg"}) OIIO::ImageOutput::create(format);
}

std::string read_with_oiio(std::string_view bytes, const std::string& format, PictureSink& sink) {
    OIIO::attribute("exr_threads", exr_threads);
    OIIO::Filesystem::IOMemReader memory(const_cast<char*>(bytes.data()), bytes.size());
    const auto input = OIIO::ImageInput::create(format, false, nullptr, &memory);
    if (!input) return "OpenImageIO was built without this format";
    OIIO::ImageSpec spec;
    OIIO::ImageSpec config;
    OIIO::Filesystem::IOProxy* proxy = &memory;
    config.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
    if (!input->open(nameless, spec, config)) return reason_of(*input);
    if (spec.deep || spec.depth > 1) return "deep and volume images are not supported";
    if (spec.width < 1 || spec.height < 1) return "the picture has no pixels";
    std::string excess = size_problem(static_cast<std::uint64_t>(spec.width),
                                      static_cast<std::uint64_t>(spec.height), spec.nchannels);
    if (!excess.empty()) return excess;

    const ChannelOrder order = channel_order(spec);
    StoredShape shape;
    shape.width = spec.width;
    shape.height = spec.height;
    shape.channels = static_cast<int>(order.channels.size());
    shape.type = SampleType::float32;
    shape.premultiplied = spec.alpha_channel >= 0;
    shape.extra_names = order.extra_names;
    if (format == "hdr") shape.orientation = radiance_orientation(bytes);
    sink.shape(shape);
    const bool read = read_rows(*input, spec, order, sink);
    return read && !input->has_error() ? std::string() : reason_of(*input);
}

std::string write_with_oiio(const StoredShape& shape, const void* pixels, const std::string& format,
                            PictureSink& sink) {
    OIIO::attribute("exr_threads", exr_threads);
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto output = OIIO::ImageOutput::create(format, &memory);
    if (!output) return "OpenImageIO was built without this format";
    OIIO::ImageSpec spec = spec_of(shape, format);
    OIIO::Filesystem::IOProxy* proxy = &memory;
    spec.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
    if (!output->open(nameless, spec)) return reason_of(*output);
    if (!output->write_image(type_of(shape.type), pixels) || output->has_error())
        return reason_of(*output);
    // has_error() is not called again: OpenImageIO reports a failure for a TIFF in memory, because
    // it has no EXIF data.
    if (!output->close()) return reason_of(*output);
    sink.bytes(bytes.data(), bytes.size());
    return {};
}

std::string write_rows_with_oiio(const StoredShape& shape, const RowsOf& rows,
                                 const std::string& format, int file) {
    OIIO::attribute("exr_threads", exr_threads);
    FileProxy proxy(file);
    const auto output = OIIO::ImageOutput::create(format, &proxy);
    if (!output) return "OpenImageIO was built without this format";
    OIIO::ImageSpec spec = spec_of(shape, format);
    OIIO::Filesystem::IOProxy* address = &proxy;
    spec.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &address);
    if (!output->open(nameless, spec)) return reason_of(*output);
    constexpr int step = 64;  // a multiple of the block height of EXR and TIFF compression
    for (int y = 0; y < shape.height; y += step) {
        const int end = std::min(y + step, shape.height);
        if (!output->write_scanlines(y, end, 0, type_of(shape.type), rows(y, end - y)) ||
            output->has_error() || !proxy.problem().empty())
            return proxy.problem().empty() ? reason_of(*output) : proxy.problem();
    }
    if (!output->close() && proxy.problem().empty()) return reason_of(*output);
    return proxy.problem();
}

}  // namespace lancer::io
