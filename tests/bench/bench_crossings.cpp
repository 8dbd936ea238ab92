// Rays aimed at edges and vertices of glass meshes, or of bodies cut from bodies: how many bodies
// stay open because a crossing was missed.
//     build/release/bin/bench_crossings [MILLIONS OF RAYS [bodies]]        default: 10
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstring>
#include <random>

#include "tests/extremes/corners.h"
#include "tests/extremes/stage.h"
#include "tracer/render.h"

namespace {

using namespace lancer;
using namespace lancer::extremes;

constexpr int side = 256;

/// A glass ball with 320 faces, possibly rotated and stretched, seen from anywhere and zoomed up to
/// 10^12 onto a vertex or an edge. The middle ray of a picture with an odd size hits this place
/// exactly.
Scene random_view(std::mt19937& random) {
    const Vec3d center(0.1, -0.2, 0.3);
    static const Mesh ball = icosphere(center, 1, 2);
    CloseView view(random, side);
    const Affine<double>& map = view.map;
    Stage& s = view.stage;
    const auto unit = [&] { return view.unit(); };
    s.add(ball, s.glass(random() % 4 == 0 ? 1 : 1 + unit()), map);
    const Mesh::Corners& face = ball.faces[random() % ball.faces.size()];
    const double share = random() % 2 == 0 ? 0 : unit();
    const Vec3d at = ball.vertices[face[0]] * (1 - share) + ball.vertices[face[1]] * share;
    const Vec3d aside(unit() - 0.5, unit() - 0.5, unit() - 0.5);
    // From outside, or from within.
    const Vec3d from =
        random() % 4 == 0 ? center + aside * 0.5 : at + normalize(at - center) * 3.0 + aside * 4.0;
    return view.of(from, at, aside);
}

}  // namespace

int main(int argc, char** argv) {
    std::uint64_t millions = 10;
    if (argc > 1) {
        const auto read = std::from_chars(argv[1], argv[1] + std::strlen(argv[1]), millions);
        if (read.ec != std::errc{} || *read.ptr != 0) {
            fmt::print(stderr, "usage: bench_crossings [MILLIONS OF RAYS [bodies]]\n");
            return 2;
        }
    }
    const bool bodies = argc > 2 && std::strcmp(argv[2], "bodies") == 0;
    std::mt19937 random(1);
    RayCounts counts;
    const auto cast = [&] { return counts.primary + counts.transmitted + counts.reflected; };
    while (cast() < millions * 1000000) {
        const Scene scene = bodies ? random_corner(random, side) : random_view(random);
        RayCounts more;
        compile(scene, scene.settings)->render({0, scene.width, scene.height, {}, false}, {}, more);
        if (more.media_lost > 0) fmt::print("{} lost after {} rays\n", more.media_lost, cast());
        const std::uint64_t before = cast();
        counts += more;
        if (cast() / 50000000 > before / 50000000)
            fmt::print(stderr, "{} rays so far, {} lost\n", cast(), counts.media_lost);
    }
    fmt::print("{} rays ({} from the camera), {} bodies left open\n", cast(), counts.primary,
               counts.media_lost);
    return counts.media_lost == 0 ? 0 : 1;
}
