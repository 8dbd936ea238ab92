// make_picture_seeds FOLDER: small pictures of every format, for the fuzzers to start from.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "model/io/image_file.h"
#include "model/io/stored_image.h"
#include "tests/io/tiff_file.h"

namespace {

using namespace lancer;
using namespace lancer::io;

Image gradient(int width, int height, int channels) {
    Image image(width, height, channels);
    for (std::size_t i = 0; i < image.data.size(); ++i)
        image.data[i] = static_cast<double>(i * 37 % 101) / 100;
    return image;
}

void write_pictures(const std::string& folder) {
    for (const int channels : {1, 3, 4}) {
        for (const char* ending : {"exr", "hdr", "jpg", "png", "ppm", "tif"}) {
            write_image(folder + "/" + std::to_string(channels) + "." + ending,
                        gradient(9, 5, channels), {channels == 3 ? 16 : 8, false});
        }
    }
    Image named = gradient(5, 3, 5);
    named.extra_names = {"depth.Z", "object.id"};
    write_image(folder + "/named.exr", named, {});
    write_image(folder + "/large.jpg", gradient(40, 24, 3), {});
}

void write_tiffs(const std::string& folder) {
    std::vector<TiffFile> files(12);
    for (TiffFile& file : files) {
        file.width = 9;
        file.height = 7;
        file.value = [](auto x, auto y, auto s) { return (x + 2 * y + 3 * s) % 2; };
    }
    files[0].separate = true;
    files[1].separate = files[1].pack_bits = true;
    files[2].tile = 16;
    files[3].tile = 16, files[3].separate = true, files[3].bits = 16;
    files[4].samples = 4, files[4].photometric = 5, files[4].tile = 16;
    files[5].samples = 5, files[5].photometric = 5, files[5].extra = {2};
    files[6].samples = 1, files[6].photometric = 3, files[6].bits = 2;
    files[6].palette.resize(12, 300);
    files[7].samples = 1, files[7].photometric = 0, files[7].bits = 1, files[7].orientation = 6;
    files[8].bits = 32, files[8].format = 3;
    files[9].samples = 2, files[9].photometric = 1, files[9].extra = {1}, files[9].bits = 12;
    files[10].rows_per_strip = 2, files[10].orientation = 3, files[10].pack_bits = true;
    files[11].bits = 16, files[11].format = 2;
    for (std::size_t i = 0; i < files.size(); ++i) {
        std::ofstream(folder + "/tiff" + std::to_string(i) + ".tif", std::ios::binary)
            << files[i].bytes();
    }
}

/// What the picture process hands over.
void write_shared(const std::string& folder) {
    const SharedMemory memory;
    SharedSink sink(memory.descriptor());
    StoredShape shape;
    shape.width = 3;
    shape.height = 2;
    shape.channels = 5;
    shape.orientation = 6;
    shape.extra_names = {"Z"};
    sink.shape(shape);
    const std::vector<unsigned char> pixels(30, 200);
    sink.bytes(pixels.data(), pixels.size());
    sink.finish("");
    std::ifstream in("/proc/self/fd/" + std::to_string(memory.descriptor()), std::ios::binary);
    std::ofstream(folder + "/picture.shared", std::ios::binary) << in.rdbuf();
}

}  // namespace

int main(int argc, char** argv) {
    try {
        if (argc != 2) return 2;
        std::filesystem::create_directories(argv[1]);
        write_pictures(argv[1]);
        write_tiffs(argv[1]);
        write_shared(argv[1]);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "make_picture_seeds: %s\n", error.what());
        return 1;
    }
}
