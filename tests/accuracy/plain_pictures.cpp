#include "tests/accuracy/plain_pictures.h"

#include <cmath>
#include <stdexcept>

namespace lancer::accuracy {
namespace {

Color grey(double v) {
    return {v, v, v};
}

/// Balls of several sizes in front of a wall that grows brighter.
Color balls(double x, double y, const TraceLimits&) {
    for (int i = 0; i < 9; ++i) {
        const double dx = x - (14.3 + 41.7 * (i % 3));
        const double dy = y - (15.9 + 31.1 * (i / 3));
        const double r = 4.2 + 1.3 * i;
        const double h = 1 - (dx * dx + dy * dy) / (r * r);
        if (h > 0) return Color{0.9, 0.4, 0.1 * i} * (0.2 + 0.8 * std::sqrt(h));
    }
    return Color{0.2, 0.3, 0.4} * (0.5 + x / 256);
}

/// Lines of a twentieth of a pixel.
Color wires(double x, double y, const TraceLimits&) {
    const double across = x * 0.97 + y * 0.23;
    const double place = across - 11.7 * std::floor(across / 11.7);
    return place < 0.05 ? grey(1) : grey(0.1);
}

/// Squares of 1 before a camera that looks along the floor.
Color checker(double x, double y, const TraceLimits&) {
    const double below = y - 30;
    if (below <= 0) return {0.4, 0.6, 0.9};
    const double far = 90 / below;
    const double aside = (x - 64) / 90 * far * 6;
    const auto parity =
        static_cast<long>(std::floor(aside)) + static_cast<long>(std::floor(far * 6));
    return parity % 2 == 0 ? grey(0.8) : grey(0.1);
}

/// Specks of an eighth of a pixel, 50 times as bright as all else.
Color sparks(double x, double y, const TraceLimits&) {
    const double cell_x = std::floor(x / 9);
    const double cell_y = std::floor(y / 9);
    const double at_x = 9 * cell_x + 4.5 + 3 * std::sin(7 * cell_x + 3 * cell_y);
    const double at_y = 9 * cell_y + 4.5 + 3 * std::cos(5 * cell_x + 11 * cell_y);
    const bool met = std::abs(x - at_x) < 0.06 && std::abs(y - at_y) < 0.06;
    return met ? grey(25) : grey(0.5);
}

/// Waves without an edge.
Color waves(double x, double y, const TraceLimits&) {
    return grey(0.5 + 0.4 * std::sin(x * x / 90) * std::cos(y / 7));
}

/// Stripes in a hall of mirrors: light comes from as many levels as are followed.
Color hall(double x, double y, const TraceLimits& limits) {
    Color sum{0, 0, 0};
    double weight = 1;
    for (int level = 0; level < limits.max_depth && weight >= limits.min_contribution; ++level) {
        const double at = (x + 0.21 * y) / 20 + 0.37 * level;
        sum += 0.3 * weight * (at - std::floor(at) < 0.5 ? Color{0.9, 0.7, 0.4} : grey(0.2));
        weight *= 0.7;
    }
    return sum;
}

}  // namespace

View view_of_128() {
    View view;
    view.width = 128;
    view.height = 96;
    return view;
}

void PlainRenderer::render_tiles(const View& view, const TakeTile& take, const Progress&,
                                 RayCounts& counts) const {
    Image image(view.width, view.height);
    std::vector<Color> color(1);
    counts = {};
    for (int y = 0; y < view.height; ++y) {
        for (int x = 0; x < view.width; ++x) {
            const PicturePoint center{x + 0.5, y + 0.5};
            trace(view, {&center, 1}, {}, color, {}, counts);
            for (int c = 0; c < 3; ++c) image.pixel(x, y)[c] = color[0][c];
        }
    }
    take(0, 0, image);
}

void PlainRenderer::trace(const View&, std::span<const PicturePoint> points,
                          const TraceLimits& limits, std::span<Color> colors, const Progress&,
                          RayCounts& counts) const {
    for (std::size_t i = 0; i < points.size(); ++i)
        colors[i] = formula_(points[i].x, points[i].y, limits);
    counts.primary += points.size();
    counts.reflected += points.size();  // so that limits seem to cut something
}

Probe PlainRenderer::probe(const View&, double x, double y) const {
    Probe probe;
    probe.color = formula_(x, y, {});
    return probe;
}

const std::vector<PlainPicture>& plain_pictures() {
    static const std::vector<PlainPicture> all{{"balls", balls},     {"wires", wires},
                                               {"checker", checker}, {"sparks", sparks},
                                               {"waves", waves},     {"hall", hall}};
    return all;
}

const Formula& plain_picture(const std::string& name) {
    for (const PlainPicture& picture : plain_pictures())
        if (picture.name == name) return picture.formula;
    throw std::invalid_argument(name);
}

Image truth_of(const Formula& formula, const View& view, int fine) {
    const TraceLimits all{60, 1e-7};
    Image image(view.width, view.height);
    for (int y = 0; y < view.height; ++y) {
        for (int x = 0; x < view.width; ++x) {
            Color sum{0, 0, 0};
            for (int j = 0; j < fine; ++j)
                for (int i = 0; i < fine; ++i)
                    // Each row is shifted by a different part of a step, so that no edge meets all
                    // rows at the same place.
                    sum += formula(x + (i + std::fmod(0.5 + j * 0.618034, 1.0)) / fine,
                                   y + (j + 0.5) / fine, all);
            for (int c = 0; c < 3; ++c) image.pixel(x, y)[c] = sum[c] / (fine * fine);
        }
    }
    return image;
}

double rms_difference(const Image& a, const Image& b) {
    double sum = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x)
            for (int c = 0; c < 3; ++c) {
                const double d = a.pixel(x, y)[c] - b.pixel(x, y)[c];
                sum += d * d;
            }
    return std::sqrt(sum / (3.0 * a.width * a.height));
}

}  // namespace lancer::accuracy
