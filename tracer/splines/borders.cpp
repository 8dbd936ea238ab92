#include "tracer/splines/borders.h"

#include <algorithm>

namespace lancer::splines {
namespace {

/// The same for both directions.
std::array<double, 12> border_key(const BorderCurve& curve) {
    std::array<double, 12> forwards{};
    std::array<double, 12> backwards{};
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const int axis = static_cast<int>(k);
            forwards[3 * i + k] = curve[i][axis];
            backwards[3 * i + k] = curve[3 - i][axis];
        }
    }
    return std::min(forwards, backwards);
}

}  // namespace

std::array<BorderCurve, 4> border_curves(const BezierPatch& p) {
    return {BorderCurve{p[0], p[1], p[2], p[3]}, BorderCurve{p[3], p[7], p[11], p[15]},
            BorderCurve{p[15], p[14], p[13], p[12]}, BorderCurve{p[12], p[8], p[4], p[0]}};
}

double border_tolerance(const BorderCurve& c, std::optional<double> tolerance) {
    return tolerance.value_or(
        hull_diagonal({Patch::Basis::bezier, 1, 4, {c.begin(), c.end()}, {}}) / 2000);
}

void BorderTolerances::add(const Patch& patch, std::optional<double> tolerance) {
    const BezierNet net = bezier_net(patch);
    for (std::size_t i = 0; i < net.rows; ++i) {
        for (std::size_t j = 0; j < net.columns; ++j) {
            for (const BorderCurve& curve : border_curves(net.patch(i, j))) {
                const double own = border_tolerance(curve, tolerance);
                const auto [at, is_new] = smallest_.emplace(border_key(curve), own);
                if (!is_new) at->second = std::min(at->second, own);
            }
        }
    }
}

std::optional<double> BorderTolerances::at(const BorderCurve& curve) const {
    const auto found = smallest_.find(border_key(curve));
    return found == smallest_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace lancer::splines
