#include "tracer/wide/flat_tori.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lancer::wide {
namespace {

/// By how much at most the map stretches a vector. It is exact for similarities. It is the square
/// root of a bound on the largest eigenvalue of the map's transposed times the map.
double stretch_of(const Affine<double>& map) {
    const auto column = [&](int i) {
        return Vec3d(map.rows[0][i], map.rows[1][i], map.rows[2][i]);
    };
    double most = 0;
    for (int i = 0; i < 3; ++i) {
        double sum = 0;
        for (int j = 0; j < 3; ++j) sum += std::abs(dot(column(i), column(j)));
        most = std::max(most, sum);
    }
    return std::sqrt(most);
}

double sum_of(const Vec3d& v) {
    const Vec3d a = absolute(v);
    return a.x + a.y + a.z;
}

Disc disc_round(const TorusSolid<double>& torus, const lancer::Frame<double>& frame) {
    Disc disc;
    const double stretch = stretch_of(frame.to_world);
    for (int i = 0; i < 3; ++i) {
        disc.center[i] = frame.to_world.shift[i];
        disc.axis[i] = frame.linear_inverse.rows[1][i];
    }
    disc.lift = frame.inverse_norm;
    disc.blur = stretch * frame.inverse_norm;
    const double reach = torus.reach() * torus.grow;
    const double moved = 0x1p-40 * sum_of(frame.to_world.shift) + 1024 * frame.transform_error;
    disc.radius = (1 + 0x1p-30) * (stretch * reach) + disc.blur * moved;
    disc.height = torus.tube * torus.grow + 0x1p-30 * reach + disc.lift * moved;
    // Squares stay in the number type's range, and rounding errors stay below the margins.
    const auto is_sound = [](double x) { return x > 0x1p-200 && x < 0x1p200; };
    if (!(is_sound(disc.radius) && is_sound(disc.lift) && disc.blur < 1024))
        disc.radius = std::numeric_limits<double>::infinity();
    return disc;
}

}  // namespace

Torus flat_torus(const TorusSolid<double>& torus, std::uint32_t frame,
                 const lancer::Frame<double>* frames) {
    lancer::Frame<double> world;
    world.norm = world.inverse_norm = 1;
    return {torus.ring, torus.tube, torus.shrink,
            torus.grow, frame,      disc_round(torus, frame == nothing ? world : frames[frame])};
}

}  // namespace lancer::wide
