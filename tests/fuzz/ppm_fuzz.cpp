#include "model/io/ppm_file.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "model/diagnostic.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace lancer;
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    if (!io::is_ppm(bytes)) return 0;
    try {
        const Image image = io::decode_ppm(bytes, "t", io::ColorSpace::automatic);
        const std::size_t values = image.index(0, image.height);
        if (values == 0 || image.data.size() != values) std::abort();
        for (const double value : image.data) {
            if (!(value >= 0 && value <= 1)) std::abort();
        }
    } catch (const FileError&) {
    }
    return 0;
}
