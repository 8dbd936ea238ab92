// The module: OpenImageIO behind two functions. See image_module.h.
#include "model/io/image_module.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <limits>
#include <vector>

#include "model/io/image_limits.h"

namespace lancer::io {
namespace {

// ---- Reading ----

/// Which channels of the file become which of ours: colour, alpha, then the others by name.
struct ChannelOrder {
    std::vector<int> channels;  ///< grey with alpha names its channel three times
    std::vector<std::string> extra_names;
};

ChannelOrder channel_order(const OIIO::ImageSpec& spec) {
    ChannelOrder order;
    std::vector<bool> taken(static_cast<std::size_t>(spec.nchannels), false);
    const auto take = [&](int channel) {
        order.channels.push_back(channel);
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
        order.channels.push_back(channel);
        order.extra_names.push_back(spec.channel_name(channel));
    }
    return order;
}

/// Reads all rows, some at a time: memory grows with what the file really holds, whatever size it
/// claims.
template <class Value>
bool read_rows(OIIO::ImageInput& input, const OIIO::ImageSpec& spec, const ChannelOrder& order,
               std::vector<double>& data) {
    const int step = spec.tile_height > 0 ? spec.tile_height : 16;
    const std::size_t width = static_cast<std::size_t>(spec.width);
    const std::size_t channels = static_cast<std::size_t>(spec.nchannels);
    std::vector<Value> rows(width * channels * static_cast<std::size_t>(step));
    for (int y = 0; y < spec.height; y += step) {
        const int begin = spec.y + y;
        const int end = spec.y + std::min(y + step, spec.height);
        const OIIO::TypeDesc type = OIIO::BaseTypeFromC<Value>::value;
        const bool read =
            spec.tile_width > 0
                ? input.read_tiles(0, 0, spec.x, spec.x + spec.width, begin, end, spec.z,
                                   spec.z + 1, 0, spec.nchannels, type, rows.data())
                : input.read_scanlines(0, 0, begin, end, spec.z, 0, spec.nchannels, type,
                                       rows.data());
        if (!read) return false;
        const std::size_t pixels = width * static_cast<std::size_t>(end - begin);
        for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
            for (const int channel : order.channels) {
                data.push_back(static_cast<double>(
                    rows[pixel * channels + static_cast<std::size_t>(channel)]));
            }
        }
    }
    return true;
}

std::string read_stored(const std::string& path, const std::string& format, StoredImage& result) {
    const auto input = OIIO::ImageInput::create(format);
    if (!input) return OIIO::geterror();
    OIIO::ImageSpec spec;
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);  // as the file has it
    if (!input->open(path, spec, config)) return input->geterror();
    if (spec.deep || spec.depth > 1) return "deep and volume images are not supported";
    if (spec.width < 1 || spec.height < 1) return "the picture has no pixels";
    std::string excess = size_problem(static_cast<std::uint64_t>(spec.width),
                                      static_cast<std::uint64_t>(spec.height), spec.nchannels);
    if (!excess.empty()) return excess;

    const ChannelOrder order = channel_order(spec);
    result.premultiplied =
        spec.alpha_channel >= 0 && spec.get_int_attribute("oiio:UnassociatedAlpha") == 0;
    result.image.width = spec.width;
    result.image.height = spec.height;
    result.image.channels = static_cast<int>(order.channels.size());
    result.image.extra_names = order.extra_names;
    std::vector<double>& data = result.image.data;
    bool read = false;
    if (spec.format == OIIO::TypeDesc::UINT8) {
        result.bits = 8;
        read = read_rows<std::uint8_t>(*input, spec, order, data);
    } else if (spec.format == OIIO::TypeDesc::UINT16) {
        result.bits = 16;
        read = read_rows<std::uint16_t>(*input, spec, order, data);
    } else if (spec.format == OIIO::TypeDesc::DOUBLE) {
        result.bits = 32;
        read = read_rows<double>(*input, spec, order, data);
    } else {
        result.bits = 32;
        read = read_rows<float>(*input, spec, order, data);
    }
    return read ? std::string() : input->geterror();
}

// ---- Writing ----

OIIO::ImageSpec spec_of(const StoredImage& stored, const std::string& format) {
    const Image& image = stored.image;
    const OIIO::TypeDesc type = stored.bits == 8    ? OIIO::TypeDesc::UINT8
                                : stored.bits == 16 ? OIIO::TypeDesc::UINT16
                                                    : OIIO::TypeDesc::FLOAT;
    OIIO::ImageSpec spec(image.width, image.height, image.channels, type);
    const int color = image.color_channels();
    spec.channelnames.clear();
    for (const char* name : {"R", "G", "B", "A"}) spec.channelnames.emplace_back(name);
    spec.channelnames.resize(static_cast<std::size_t>(color));
    if (color == 1) spec.channelnames = {"Y"};
    spec.channelnames.insert(spec.channelnames.end(), image.extra_names.begin(),
                             image.extra_names.end());
    spec.alpha_channel = color == 4 ? 3 : -1;
    if (!stored.premultiplied && color == 4) spec.attribute("oiio:UnassociatedAlpha", 1);
    if (format == "jpeg") {
        spec.attribute("compression", "jpeg:95");
        spec.attribute("jpeg:subsampling", "4:4:4");
    } else {
        spec.attribute("compression", "zip");
        spec.attribute("DateTime", "1970:01:01 00:00:00");  // else the time of writing, in EXR
    }
    return spec;
}

template <class Value>
bool write_rows(OIIO::ImageOutput& output, const Image& image) {
    // Doubles too large for a float become infinite, as IEEE 754 rounds them.
    std::vector<Value> values(image.data.size());
    std::transform(image.data.begin(), image.data.end(), values.begin(),
                   [](double v) { return static_cast<Value>(v); });
    const OIIO::TypeDesc type = OIIO::BaseTypeFromC<Value>::value;
    return output.write_image(type, values.data());
}

std::string write_stored(const std::string& path, const std::string& format,
                         const StoredImage& stored) {
    const auto output = OIIO::ImageOutput::create(format);
    if (!output) return OIIO::geterror();
    if (!output->open(path, spec_of(stored, format))) return output->geterror();
    const bool written = stored.bits == 8    ? write_rows<std::uint8_t>(*output, stored.image)
                         : stored.bits == 16 ? write_rows<std::uint16_t>(*output, stored.image)
                                             : write_rows<float>(*output, stored.image);
    if (!written || !output->close()) return output->geterror();
    return {};
}

/// Runs `action` and turns whatever goes wrong into words.
template <class Action>
std::string guarded(Action action) {
    try {
        return action();
    } catch (const std::bad_alloc&) {
        return "out of memory";
    } catch (const std::exception& error) {
        return std::string("OpenImageIO: ") + error.what();
    }
}

const ImageModule functions{
    [](const std::string& path, const std::string& format, StoredImage& result) {
        return guarded([&] { return read_stored(path, format, result); });
    },
    [](const std::string& path, const std::string& format, const StoredImage& stored) {
        return guarded([&] { return write_stored(path, format, stored); });
    }};

}  // namespace
}  // namespace lancer::io

const lancer::io::ImageModule* lancer_image_module() {
    return &lancer::io::functions;
}
