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

class FileInMemory {
  public:
    FileInMemory(const void* data, std::size_t size) {
        lancer::io::write_at(memory_.descriptor(), data, size, 0);
    }
    const std::string& name() const { return name_; }
    lancer::Image read() const {
        return lancer::io::read_texture(name_, lancer::io::ColorSpace::automatic);
    }

  private:
    lancer::io::SharedMemory memory_;
    std::string name_ = "/proc/self/fd/" + std::to_string(memory_.descriptor());
};

/// The program or the module may be missing, or unable to start again. The words of a message do
/// not tell this, because libraries quote the file in theirs.
void require_that_sound_pictures_are_read() {
    constexpr std::string_view radiance =
        "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n\x80\x80\x80\x80";
    static const FileInMemory sound(radiance.data(), radiance.size());
    require(sound.read().width == 1);
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
    lancer::io::set_picture_limits({256, 5});
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace lancer;
    const FileInMemory file(data, size);
    try {
        const Image image = file.read();
        require(image.channels == 3 || image.channels == 4);
        require(image.width > 0 && image.data.size() == image.index(0, image.height));
        for (const double value : image.data) require(std::isfinite(value));
    } catch (const FileError& error) {
        const std::string_view text = error.what();
        require(text.find(file.name()) != std::string_view::npos);
        for (const char c : text) require(static_cast<unsigned char>(c) >= ' ');
        static unsigned refused = 0;
        if (refused++ % 64 == 0) require_that_sound_pictures_are_read();  // each takes a while
    }
    return 0;
}
