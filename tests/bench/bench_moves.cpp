// Scenes of turned shapes that touch glass, moved so that no coordinate loses a digit: how many
// pixels have another bit, and where.
//     build/release/bin/bench_moves [SCENES [FIRST SEED [any|ends]]]     default: 100 from 1
// The shapes are turned by quarters, by any angle, or so that ends of shapes are rounded, too.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "model/similar.h"
#include "tests/extremes/turned_scene.h"
#include "tracer/render.h"

namespace {

using namespace lancer;

Image picture_of(const Scene& scene) {
    Settings settings = scene.settings;
    settings.threads = 0;
    RayCounts counts;
    return compile(scene, settings)->render({0, scene.width, scene.height, {}, false}, {}, counts);
}

}  // namespace

int main(int argc, char** argv) {
    const unsigned count = argc > 1 ? static_cast<unsigned>(std::atoi(argv[1])) : 100;
    const unsigned first = argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 1;
    const std::string_view by = argc > 3 ? argv[3] : "";
    const auto turns = by == "any"    ? extremes::Turns::any
                       : by == "ends" ? extremes::Turns::any_ends
                                      : extremes::Turns::quarters;
    std::size_t pixels = 0;
    std::size_t different = 0;
    for (unsigned seed = first; seed < first + count; ++seed) {
        const Scene scene = extremes::random_turned(seed, turns);
        const Image image = picture_of(scene);
        for (const double d : {1e6, 3221225472.0, 1e9, 1e11}) {
            const Image other = picture_of(moved(scene, {d, -d, 2 * d}));
            for (int y = 0; y < image.height; ++y) {
                for (int x = 0; x < image.width; ++x) {
                    ++pixels;
                    const double* a = image.pixel(x, y);
                    if (std::equal(a, a + 3, other.pixel(x, y))) continue;
                    ++different;
                    double most = 0;
                    for (int c = 0; c < 3; ++c)
                        most = std::max(most, std::abs(a[c] - other.pixel(x, y)[c]));
                    fmt::print("seed {}, moved by {:g}, pixel {}, {}: by {:.1e}\n", seed, d, x, y,
                               most);
                }
            }
        }
    }
    fmt::print("{} of {} pixels have another bit\n", different, pixels);
    return different == 0 ? 0 : 1;
}
