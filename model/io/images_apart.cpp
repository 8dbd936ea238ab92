#include "model/io/images_apart.h"

#include <fmt/format.h>

#include <algorithm>
#include <type_traits>
#include <vector>

#include "model/diagnostic.h"
#include "model/io/picture_process.h"
#include "model/io/quantize.h"
#include "model/io/stored_image.h"

namespace lancer::io {
namespace {

/// The numbers that stand in a file of this format, into `sink`.
template <class Value>
void store(const Image& image, const StoredShape& shape, const std::string& format,
           const ImageWriteOptions& options, SharedSink& sink) {
    sink.shape(shape);
    const int color = image.color_channels();
    const int last =
        std::min(shape.channels, format == "hdr" ? std::min(color, 3) : image.channels) - 1;
    const Quantizer quantizer(sizeof(Value) == 1 ? 8 : 16, options.linear);
    const std::size_t row_values = shape.row_bytes() / sizeof(Value);
    std::vector<Value> row(row_values);
    const double* pixel = image.data.data();
    for (int y = 0; y < image.height; ++y) {
        Value* out = row.data();
        for (int x = 0; x < image.width; ++x, pixel += image.channels) {
            for (int c = 0; c < shape.channels; ++c) {
                double value = pixel[std::min(c, last)];
                if constexpr (std::is_integral_v<Value>) {
                    const bool alpha = c == 3 && color == 4;
                    value = alpha ? quantizer.raw(value) : quantizer.encoded(value);
                } else if (shape.premultiplied && c < 3) {
                    value *= pixel[3];
                } else if (format == "hdr") {
                    constexpr double most = 1e38;  // 2^127 is 1.7e38
                    value = value > 0 ? std::min(value, most) : 0;
                }
                // A double too large for a float becomes infinite, as IEEE 754 rounds it.
                *out++ = static_cast<Value>(value);
            }
        }
        sink.bytes(row.data(), shape.row_bytes());
    }
    sink.finish("");
}

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
        if (format == "hdr") shape.channels = 3;  // RGBE has nothing else
    }
    const bool whole = format == "tiff" || format == "jpeg";
    shape.type = !whole                                   ? SampleType::float32
                 : format == "tiff" && options.bits == 16 ? SampleType::uint16
                                                          : SampleType::uint8;
    return shape;
}

/// What the picture process made of `input`, in `output`. Throws FileError.
SharedResult worked(PictureTask task, const std::string& format, int input, int output,
                    const std::string& path) {
    std::string problem = work_on_picture(task, format, input, output);
    SharedResult result;
    if (problem.empty()) {
        result = read_shared(output);
        problem = result.problem;
        const bool is_picture = result.shape.width > 0;
        if (problem.empty() && is_picture != (task == PictureTask::read))
            problem = "the process that works on pictures failed";
    }
    if (!problem.empty()) {
        throw FileError(fmt::format("cannot {} '{}': {}",
                                    task == PictureTask::read ? "read" : "write", path, problem));
    }
    return result;
}

}  // namespace

std::string encode_apart(const Image& image, const std::string& format, const std::string& path,
                         const ImageWriteOptions& options) {
    const StoredShape shape = shape_to_store(image, format, options);
    const SharedMemory input;
    const SharedMemory output;
    SharedSink sink(input.descriptor());
    switch (shape.type) {
        case SampleType::uint8:
            store<std::uint8_t>(image, shape, format, options, sink);
            break;
        case SampleType::uint16:
            store<std::uint16_t>(image, shape, format, options, sink);
            break;
        default:
            store<float>(image, shape, format, options, sink);
            break;
    }
    const SharedResult result =
        worked(PictureTask::write, format, input.descriptor(), output.descriptor(), path);
    return shared_bytes(output.descriptor(), result);
}

Image read_apart(const std::string& path, const std::string& format, int input, ColorSpace space) {
    const SharedMemory output;
    const SharedResult result = worked(PictureTask::read, format, input, output.descriptor(), path);
    return shared_image(output.descriptor(), result, space);
}

}  // namespace lancer::io
