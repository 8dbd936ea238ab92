#include "model/io/ppm_file.h"

#include "tests/fuzz/picture_fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace lancer::io;
    return fuzz_picture(data, size, is_ppm, decode_ppm);
}
