#include "judge/against/shift_fit.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "judge/explain/probe_function.h"

namespace lancer::judge {

namespace {

constexpr double slope_step = 0.02;  // pixels, on each side
constexpr int rounds = 12;
/// The spacing of the shifts that are tried first, in pixels; `steps` of them on each side.
constexpr double spacing = 0.5;
constexpr int steps = 3;
constexpr std::size_t starts = 2;         ///< how many of the best shifts are refined
constexpr std::size_t most_points = 800;  ///< the number of points at which shifts are compared

class ShiftFinder {
  public:
    ShiftFinder(const TrialPixels& samples, const VariantTracer& tracer, const Scene& scene,
                const Renderer& renderer)
        : samples_(samples), tracer_(tracer), scene_(scene), renderer_(renderer) {}

    std::vector<Color> at(double x, double y) const {
        std::vector<PicturePoint> points = samples_.points;
        for (PicturePoint& p : points) {
            p.x += x;
            p.y += y;
        }
        return tracer_.trace(renderer_, scene_.settings, points);
    }

    /// The sum of the differences, each limited so that edges count little.
    double misfit(double x, double y) const {
        const std::vector<Color> colors = at(x, y);
        double sum = 0;
        for (std::size_t i = 0; i < colors.size(); ++i)
            sum += std::min(0.05, distance(as_held(colors[i], samples_), samples_.theirs[i]));
        return sum;
    }

    /// One Gauss-Newton step from (x, y). A difference has a small weight when the slope does not
    /// account for it within `reach` pixels: then an edge caused it.
    std::optional<PicturePoint> better(double x, double y, double reach) const {
        const std::vector<Color> here = at(x, y);
        const std::vector<Color> left = at(x - slope_step, y);
        const std::vector<Color> right = at(x + slope_step, y);
        const std::vector<Color> above = at(x, y - slope_step);
        const std::vector<Color> below = at(x, y + slope_step);
        double xx = 0, xy = 0, yy = 0, xd = 0, yd = 0;
        for (std::size_t i = 0; i < here.size(); ++i) {
            for (int c = 0; c < 3; ++c) {
                if (samples_.clipped && (here[i][c] >= 1 || samples_.theirs[i][c] >= 1)) continue;
                const double gx = (right[i][c] - left[i][c]) / (2 * slope_step);
                const double gy = (below[i][c] - above[i][c]) / (2 * slope_step);
                const double d = samples_.theirs[i][c] - here[i][c];
                if (!is_slope(left[i][c], here[i][c], right[i][c]) ||
                    !is_slope(above[i][c], here[i][c], below[i][c]))
                    continue;
                const double moved = reach * std::hypot(gx, gy);
                if (!(moved > 0)) continue;
                const double weight = 1 / (1 + d * d / (moved * moved));
                xx += weight * gx * gx;
                xy += weight * gx * gy;
                yy += weight * gy * gy;
                xd += weight * gx * d;
                yd += weight * gy * d;
            }
        }
        const double determinant = xx * yy - xy * xy;
        if (!(determinant > 1e-9 * xx * yy)) return std::nullopt;
        const double dx = std::clamp((yy * xd - xy * yd) / determinant, -0.25, 0.25);
        const double dy = std::clamp((xx * yd - xy * xd) / determinant, -0.25, 0.25);
        return PicturePoint{x + dx, y + dy};
    }

    /// False when an edge lies between two of the values.
    static bool is_slope(double before, double here, double behind) {
        return std::abs(before - 2 * here + behind) <= 0.2 * std::abs(behind - before) + 1e-9;
    }

    struct Place {
        PicturePoint shift;
        double misfit = 0;
    };

    /// The best shifts of a grid, by increasing misfit.
    std::vector<Place> good_places() const {
        std::vector<Place> places;
        for (int j = -steps; j <= steps; ++j) {
            for (int i = -steps; i <= steps; ++i) {
                const PicturePoint shift{i * spacing, j * spacing};
                places.push_back({shift, misfit(shift.x, shift.y)});
            }
        }
        std::stable_sort(places.begin(), places.end(),
                         [](const Place& a, const Place& b) { return a.misfit < b.misfit; });
        places.resize(starts);
        return places;
    }

    /// The shift with the least misfit on the way from `start`. The first step trusts slopes over
    /// `reach` pixels; each later one over half the distance of the step before.
    Place refined(const Place& start, double reach) const {
        Place best = start;
        PicturePoint place = start.shift;
        for (int round = 0; round < rounds; ++round) {
            const auto next = better(place.x, place.y, std::max(2e-3, std::ldexp(reach, -round)));
            if (!next || std::hypot(next->x, next->y) > 4) break;
            const bool has_come = std::hypot(next->x - place.x, next->y - place.y) < 1e-5;
            place = *next;
            const double found = misfit(place.x, place.y);
            if (found < best.misfit) best = {place, found};
            if (has_come) break;
        }
        return best;
    }

  private:
    const TrialPixels& samples_;
    const VariantTracer& tracer_;
    const Scene& scene_;
    const Renderer& renderer_;
};

std::string shift_words(double x, double y, double center_x, double center_y) {
    // Smaller differences do not count as a shift (Thresholds::shift).
    const auto rounded = [](double v) { return std::round(v * 1e3) / 1e3 + 0.0; };
    const double px = rounded(center_x + x);
    const double py = rounded(center_y + y);
    // If the rays go further to the right, the picture moves to the left.
    std::vector<std::string> ways;
    if (rounded(x) != 0)
        ways.push_back(fmt::format("{:g} pixel to the {}", std::abs(rounded(x)),
                                   rounded(x) > 0 ? "left" : "right"));
    if (rounded(y) != 0)
        ways.push_back(
            fmt::format("{:g} pixel {}", std::abs(rounded(y)), rounded(y) > 0 ? "up" : "down"));
    std::string words = fmt::format(
        "the picture is shifted by {}: its rays pass ({:g}, {:g}) pixel from the assumed points, x "
        "to the right and y down",
        fmt::join(ways, " and "), rounded(x), rounded(y));
    if (px >= 0 && px <= 1 && py >= 0 && py <= 1) {
        words += px == py ? fmt::format(" (--pixel-center {:g})", px)
                          : fmt::format(" (--pixel-center {:g},{:g})", px, py);
    }
    return words;
}

}  // namespace

std::vector<Explanation> turned_pictures(const TrialPixels& samples, const VariantTracer& tracer,
                                         const Scene& scene, const Renderer& renderer) {
    const auto turned = [&](bool x, bool y, const char* words) {
        std::vector<PicturePoint> points = samples.points;
        for (PicturePoint& p : points) {
            if (x) p.x = tracer.view().width - p.x;
            if (y) p.y = tracer.view().height - p.y;
        }
        return Explanation{words, tracer.trace(renderer, scene.settings, points)};
    };
    return {turned(false, true, "the picture is upside down: its rows begin at the bottom"),
            turned(true, false,
                   "left and right are exchanged: the scene was read as left-handed, or the "
                   "camera's right vector points left"),
            turned(true, true, "the picture is turned by half a turn")};
}

Explanation shifted_picture(const TrialPixels& samples, const VariantTracer& tracer,
                            const Scene& scene, const Renderer& renderer, double center_x,
                            double center_y) {
    const TrialPixels few = few_of(samples, most_points);
    const ShiftFinder rough(few, tracer, scene, renderer);
    ShiftFinder::Place best{{0, 0}, std::numeric_limits<double>::infinity()};
    for (const ShiftFinder::Place& place : rough.good_places()) {
        const ShiftFinder::Place found = rough.refined(place, spacing);
        if (found.misfit < best.misfit) best = found;
    }
    const ShiftFinder finder(samples, tracer, scene, renderer);
    best.misfit = finder.misfit(best.shift.x, best.shift.y);
    const PicturePoint shift = finder.refined(best, 4e-3).shift;
    // A program that shifts its picture has no values for the border that comes in.
    const View& view = tracer.view();
    std::vector<std::uint8_t> left_out;
    for (const PicturePoint& p : samples.points) {
        const bool is_inside = p.x + shift.x >= 0 && p.x + shift.x <= view.width &&
                               p.y + shift.y >= 0 && p.y + shift.y <= view.height;
        left_out.push_back(is_inside ? 0 : 1);
    }
    return {shift_words(shift.x, shift.y, center_x, center_y), finder.at(shift.x, shift.y), true,
            std::move(left_out)};
}

}  // namespace lancer::judge
