// Files of every format, read like textures. Whatever happens in the picture process, the result is
// a complete picture of finite values or a FileError that names the file.
#include <unistd.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "model/diagnostic.h"
#include "model/io/picture_process.h"
#include "model/io/stored_image.h"
#include "model/io/texture_file.h"

namespace {

void require(bool condition) {
    if (!condition) std::abort();
}

lancer::Image read(const void* data, std::size_t size, std::string& name) {
    const lancer::io::SharedMemory file;
    lancer::io::write_at(file.descriptor(), data, size, 0);
    name = "/proc/self/fd/" + std::to_string(file.descriptor());
    return lancer::io::read_texture(name, lancer::io::ColorSpace::automatic);
}

}  // namespace

// A failure must not come from a missing program or module. The words of a later message do not
// tell this, because libraries quote the file in theirs.
extern "C" int LLVMFuzzerInitialize(int*, char***) {
    lancer::io::set_picture_limits({256, 5});
    constexpr std::string_view radiance =
        "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n\x80\x80\x80\x80";
    std::string name;
    require(read(radiance.data(), radiance.size(), name).width == 1);
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace lancer;
    using namespace lancer::io;
    std::string name;
    try {
        const Image image = read(data, size, name);
        require(image.channels == 3 || image.channels == 4);
        require(image.width > 0 && image.data.size() == image.index(0, image.height));
        for (const double value : image.data) require(std::isfinite(value));
    } catch (const FileError& error) {
        const std::string_view text = error.what();
        require(text.find(name) != std::string_view::npos);
        for (const char c : text) require(static_cast<unsigned char>(c) >= ' ');
    }
    return 0;
}
