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

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace lancer;
    using namespace lancer::io;
    set_picture_limits({256, 5});
    const SharedMemory file;
    write_at(file.descriptor(), data, size, 0);
    const std::string name = "/proc/self/fd/" + std::to_string(file.descriptor());
    try {
        const Image image = read_texture(name, ColorSpace::automatic);
        require(image.channels == 3 || image.channels == 4);
        require(image.width > 0 && image.data.size() == image.index(0, image.height));
        for (const double value : image.data) require(std::isfinite(value));
    } catch (const FileError& error) {
        const std::string_view text = error.what();
        require(text.find(name) != std::string_view::npos);
        for (const char c : text) require(static_cast<unsigned char>(c) >= ' ');
        // A failure must not come from a missing program or module.
        require(text.find("cannot start") == std::string_view::npos);
        require(text.find("cannot be loaded") == std::string_view::npos);
    }
    return 0;
}
