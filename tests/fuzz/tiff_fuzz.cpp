// The TIFF reader, without the picture process.
#include "model/io/module/tiff.h"

#include "tests/fuzz/stored_picture.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace lancer::io;
    return fuzz_stored_picture(data, size, read_tiff);
}
