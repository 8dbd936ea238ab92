// Any MTL text: values in their ranges, or a FileError that names the file.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "model/diagnostic.h"
#include "model/io/mtl_reader.h"

namespace {

void require(bool condition) {
    if (!condition) std::abort();
}

void require_color(const std::optional<lancer::Color>& color) {
    if (color)
        require(lancer::is_finite(*color) && color->x >= 0 && color->y >= 0 && color->z >= 0);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace lancer;
    try {
        const std::string_view bytes(reinterpret_cast<const char*>(data), size);
        for (const io::MtlMaterial& m : io::read_mtl(bytes, "t.mtl").materials) {
            for (const auto& color : {m.ambient, m.diffuse, m.specular, m.emission})
                require_color(color);
            require(!m.opacity || (*m.opacity >= 0 && *m.opacity <= 1));
            require(!m.ior || (*m.ior > 0 && std::isfinite(*m.ior)));
            require(!m.shininess || (*m.shininess >= 0 && std::isfinite(*m.shininess)));
            require(!m.illumination || (*m.illumination >= 0 && *m.illumination <= 10));
        }
    } catch (const FileError& error) {
        require(std::string_view(error.what()).starts_with("t.mtl"));
    }
    return 0;
}
