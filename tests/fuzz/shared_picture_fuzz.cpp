// The output of a picture process that a file has taken over: a complete picture, the bytes of a
// file, or a reason on one line.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "model/io/stored_image.h"

namespace {

void require(bool condition) {
    if (!condition) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace lancer;
    using namespace lancer::io;
    const SharedMemory memory;
    write_at(memory.descriptor(), data, size, 0);
    const SharedResult result = read_shared(memory.descriptor());
    for (const char c : result.problem) require(static_cast<unsigned char>(c) >= ' ');
    if (!result.problem.empty()) return 0;
    if (result.shape.width == 0) {
        require(shared_bytes(memory.descriptor(), result).size() <= size);
        return 0;
    }
    const Image image = shared_image(memory.descriptor(), result, ColorSpace::automatic);
    require(image.width > 0 && image.data.size() == image.index(0, image.height));
    require(image.color_channels() == 1 || image.color_channels() == 3 ||
            image.color_channels() == 4);
    return 0;
}
