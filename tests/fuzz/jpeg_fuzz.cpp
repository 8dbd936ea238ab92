// The JPEG reader, without the picture process.
#include "model/io/module/jpeg.h"

#include "model/io/image_checks.h"
#include "tests/fuzz/stored_picture.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace lancer::io;
    return fuzz_stored_picture(data, size, [](std::string_view bytes, PictureSink& sink) {
        std::string problem = jpeg_problem(bytes);
        return problem.empty() ? read_jpeg(bytes, sink) : problem;
    });
}
