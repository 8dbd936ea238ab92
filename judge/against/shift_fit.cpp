#include "judge/against/shift_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "judge/explain/probe_function.h"

namespace lancer::judge {

namespace {

constexpr double slope_step = 0.02;  // pixels, on each side
constexpr int rounds = 12;

class ShiftFinder {
  public:
    ShiftFinder(const Samples& samples, const VariantTracer& tracer, const Scene& scene,
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

    /// The sum of the differences, each up to a bound: what edges do counts for little.
    double misfit(const std::vector<Color>& colors) const {
        double sum = 0;
        for (std::size_t i = 0; i < colors.size(); ++i)
            sum += std::min(0.05, distance(as_held(colors[i], samples_), samples_.theirs[i]));
        return sum;
    }

    /// One step of Gauss and Newton from (x, y). A difference weighs less where the slope would
    /// have to be followed further than `reach` pixels to make it: there an edge makes it.
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
                // An edge between the points of the slope is none.
                if (std::abs(gx) > 1 || std::abs(gy) > 1) continue;
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

    PicturePoint find() const {
        PicturePoint best{0, 0};
        double least = misfit(at(0, 0));
        for (const double y : {0.0, -0.5, 0.5, -1.0, 1.0}) {
            for (const double x : {0.0, -0.5, 0.5, -1.0, 1.0}) {
                const double found = misfit(at(x, y));
                if (found >= least) continue;
                least = found;
                best = {x, y};
            }
        }
        PicturePoint place = best;
        for (int round = 0; round < rounds; ++round) {
            const auto next = better(place.x, place.y, std::max(2e-3, std::ldexp(0.5, -round)));
            if (!next || std::hypot(next->x, next->y) > 4) break;
            place = *next;
            const double found = misfit(at(place.x, place.y));
            if (found >= least) continue;
            least = found;
            best = place;
        }
        return best;
    }

  private:
    const Samples& samples_;
    const VariantTracer& tracer_;
    const Scene& scene_;
    const Renderer& renderer_;
};

std::string shift_words(double x, double y, double center_x, double center_y) {
    const auto round4 = [](double v) { return std::round(v * 1e4) / 1e4 + 0.0; };
    const double px = round4(center_x + x);
    const double py = round4(center_y + y);
    std::string words = fmt::format(
        "its rays go through points ({:g}, {:g}) pixel beside those assumed, x to "
        "the right and y down",
        round4(x), round4(y));
    if (px >= 0 && px <= 1 && py >= 0 && py <= 1) {
        words += px == py ? fmt::format(" (--pixel-center {:g})", px)
                          : fmt::format(" (--pixel-center {:g},{:g})", px, py);
    }
    return words;
}

}  // namespace

std::vector<Explanation> turned_pictures(const Samples& samples, const VariantTracer& tracer,
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
                   "left and right are exchanged: the scene was taken to be left-handed, or the "
                   "camera's right side points left"),
            turned(true, true, "the picture is turned by half a turn")};
}

Explanation shifted_picture(const Samples& samples, const VariantTracer& tracer, const Scene& scene,
                            const Renderer& renderer, double center_x, double center_y) {
    const ShiftFinder finder(samples, tracer, scene, renderer);
    const PicturePoint place = finder.find();
    return {shift_words(place.x, place.y, center_x, center_y), finder.at(place.x, place.y)};
}

}  // namespace lancer::judge
