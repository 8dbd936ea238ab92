#include "model/io/images_apart.h"

#include <fmt/format.h>

#include "model/diagnostic.h"
#include "model/io/picture_process.h"

namespace lancer::io {
namespace {

/// Has the picture process work on `input`, and returns its result in `output`. Throws FileError.
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

std::string encode_apart(const StoredShape& shape, const RowOf& row, const std::string& format,
                         const std::string& path) {
    const SharedMemory input;
    const SharedMemory output;
    SharedSink sink(input.descriptor());
    sink.shape(shape);
    for (int y = 0; y < shape.height; ++y) sink.bytes(row(y), shape.row_bytes());
    sink.finish("");
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
