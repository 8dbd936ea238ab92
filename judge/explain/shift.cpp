#include "judge/explain/shift.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace lancer::judge {

namespace {

/// Normal equations of `gradient . shift = difference`.
struct NormalEquations {
    double xx = 0, xy = 0, yy = 0;
    double xd = 0, yd = 0, dd = 0;
    std::size_t count = 0;

    void add(double gx, double gy, double d) {
        xx += gx * gx;
        xy += gx * gy;
        yy += gy * gy;
        xd += gx * d;
        yd += gy * d;
        dd += d * d;
        ++count;
    }
};

Shift solve(const NormalEquations& n) {
    const double determinant = n.xx * n.yy - n.xy * n.xy;
    // With all gradients in one direction, or none, a shift is not determined.
    if (n.count < 16 || !(determinant > 1e-9 * n.xx * n.yy)) return {};
    Shift shift;
    shift.count = n.count;
    shift.x = (n.yy * n.xd - n.xy * n.yd) / determinant;
    shift.y = (n.xx * n.yd - n.xy * n.xd) / determinant;
    const double residual = std::max(0.0, n.dd - shift.x * n.xd - shift.y * n.yd);
    const double variance = residual / static_cast<double>(n.count - 2);
    shift.error_x = std::sqrt(variance * n.yy / determinant);
    shift.error_y = std::sqrt(variance * n.xx / determinant);
    return shift;
}

/// The quantile of Student's t with the same tail probability as `sigmas` standard deviations of a
/// normal distribution: the standard error is estimated from the spread of the `count` offsets
/// themselves. Student, "The Probable Error of a Mean", Biometrika 6(1) 1908. Of two offsets, every
/// fifth pair would exceed 3.
double as_few(double sigmas, std::size_t count) {
    const boost::math::normal known;
    const boost::math::students_t estimated(static_cast<double>(count - 1));
    return quantile(complement(estimated, cdf(complement(known, sigmas))));
}

}  // namespace

double Shift::length() const {
    return std::hypot(x, y);
}

bool Shift::is_significant(double least, double sigmas) const {
    const double long_enough = length();
    if (count < 2 || long_enough <= least) return false;
    const double error = std::hypot(error_x * x, error_y * y) / long_enough;
    return long_enough > as_few(sigmas, count) * error;
}

Shift register_pictures(const Image& ours, const Image& theirs, const Mask& skip) {
    NormalEquations equations;
    const auto skipped = [&](int x, int y) { return skip[index_of(ours, x, y)] != 0; };
    for (int y = 1; y + 1 < ours.height; ++y) {
        for (int x = 1; x + 1 < ours.width; ++x) {
            if (skipped(x, y) || skipped(x - 1, y) || skipped(x + 1, y) || skipped(x, y - 1) ||
                skipped(x, y + 1)) {
                continue;
            }
            for (int c = 0; c < 3; ++c) {
                const double gx = 0.5 * (ours.pixel(x + 1, y)[c] - ours.pixel(x - 1, y)[c]);
                const double gy = 0.5 * (ours.pixel(x, y + 1)[c] - ours.pixel(x, y - 1)[c]);
                if (gx == 0 && gy == 0) continue;
                // theirs(p) = ours(p - s): the difference is minus the gradient times the shift.
                equations.add(-gx, -gy, theirs.pixel(x, y)[c] - ours.pixel(x, y)[c]);
            }
        }
    }
    return solve(equations);
}

Shift mean_offset(const std::vector<Offset>& offsets) {
    Shift mean;
    const auto n = static_cast<double>(offsets.size());
    mean.count = offsets.size();
    if (offsets.empty()) return mean;
    for (const Offset& o : offsets) {
        mean.x += o.x / n;
        mean.y += o.y / n;
    }
    if (offsets.size() < 2) return {0, 0, 0, 0, 0};  // one offset gives no error
    for (const Offset& o : offsets) {
        mean.error_x += (o.x - mean.x) * (o.x - mean.x);
        mean.error_y += (o.y - mean.y) * (o.y - mean.y);
    }
    mean.error_x = std::sqrt(mean.error_x / (n * (n - 1)));
    mean.error_y = std::sqrt(mean.error_y / (n * (n - 1)));
    return mean;
}

}  // namespace lancer::judge
