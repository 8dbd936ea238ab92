#include "model/io/ppm_file.h"

#include "model/io/pfm_file.h"
#include "tests/fuzz/picture_fuzz.h"

namespace {

/// Floats may have any value; their number must fit the size.
void fuzz_floats(std::string_view bytes) {
    using namespace lancer;
    if (!io::is_pfm(bytes)) return;
    try {
        const Image image = io::decode_pfm(bytes, "t");
        const std::size_t values = image.index(0, image.height);
        if (values == 0 || image.data.size() != values) std::abort();
    } catch (const FileError&) {
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace lancer::io;
    fuzz_floats({reinterpret_cast<const char*>(data), size});
    return fuzz_picture(data, size, is_ppm, decode_ppm);
}
