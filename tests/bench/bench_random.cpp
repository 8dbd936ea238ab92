// Random scenes of every shape, material, texture, light and camera, in double against 113 bits:
// how many pixels are wrong, and where.
//     build/release/bin/bench_random [SCENES [FIRST SEED]]        default: 100 from 1
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "tests/extremes/random_scene.h"
#include "tests/quad/renderer.h"

namespace {

using namespace lancer;

/// As in docs/accuracy.md: more than 1/255 off in a channel, both clipped.
bool is_wrong(const double* a, const double* b) {
    bool off = false;
    for (int c = 0; c < 3; ++c)
        off = off ||
              !(std::abs(std::clamp(a[c], 0.0, 1.0) - std::clamp(b[c], 0.0, 1.0)) <= 1.0 / 255);
    return off;
}

void tell(const char* type, const Renderer& renderer, const View& view, int x, int y) {
    const Probe p = renderer.probe(view, x + 0.5, y + 0.5);
    fmt::print("  {:6}: {:.6f} {:.6f} {:.6f}, object {}, depth {:.17g}, {} rays\n", type, p.color.x,
               p.color.y, p.color.z, p.object == none ? -1 : static_cast<int>(p.object), p.depth,
               p.rays);
}

}  // namespace

int main(int argc, char** argv) {
    const unsigned count = argc > 1 ? static_cast<unsigned>(std::atoi(argv[1])) : 100;
    const unsigned first = argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 1;
    std::size_t pixels = 0;
    std::size_t wrong = 0;
    for (unsigned seed = first; seed < first + count; ++seed) {
        const Scene scene = extremes::random_anything(seed);
        Settings settings = scene.settings;
        settings.threads = 0;
        View view;
        view.width = scene.width;
        view.height = scene.height;
        const auto renderer = compile(scene, settings);
        const auto judge = compile_quad(scene, settings);
        RayCounts counts;
        const Image image = renderer->render(view, {}, counts);
        const Image truth = judge->render(view, {}, counts);
        for (int y = 0; y < view.height; ++y) {
            for (int x = 0; x < view.width; ++x) {
                ++pixels;
                if (!is_wrong(image.pixel(x, y), truth.pixel(x, y))) continue;
                ++wrong;
                fmt::print("seed {}, pixel {}, {}\n", seed, x, y);
                tell("double", *renderer, view, x, y);
                tell("quad", *judge, view, x, y);
            }
        }
    }
    fmt::print("{} of {} pixels wrong\n", wrong, pixels);
}
