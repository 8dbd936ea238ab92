#include <string_view>

#include "tests/fuzz/mesh_fuzz.h"
#include "tests/io/read_in_chunks.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace lancer::io;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    require(told(text, {}) == told(text, {.threads = 1, .chunk_bytes = 1 + size % 30}));
    return fuzz_mesh(data, size, "t.obj");
}
