#include "tests/extremes/picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/quad/renderer.h"

namespace lancer::extremes {
namespace {

Image checked_picture(const Renderer& renderer, const Scene& scene) {
    RayCounts counts;
    View view;
    view.width = scene.width;
    view.height = scene.height;
    Image image = renderer.render(view, {}, counts);
    EXPECT_EQ(counts.media_lost, 0u);
    int bad = 0;
    for (const double x : image.data) bad += !std::isfinite(x);
    EXPECT_EQ(bad, 0) << "values that are not finite";
    return image;
}

double apart(const double* a, const double* b) {
    double most = 0;
    for (int c = 0; c < 3; ++c) {
        const double d = std::abs(std::clamp(a[c], 0.0, 1.0) - std::clamp(b[c], 0.0, 1.0));
        most = std::max(most, d);
    }
    return most;
}

template <class Bad>
int count(const Image& a, const Bad& bad) {
    int n = 0;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) n += bad(x, y);
    }
    return n;
}

}  // namespace

Image picture(const Scene& scene, Precision precision) {
    Settings settings = scene.settings;
    settings.precision = precision;
    return checked_picture(*compile(scene, settings), scene);
}
Image quad_picture(const Scene& scene) {
    return checked_picture(*compile_quad(scene, scene.settings), scene);
}

int wrong(const Image& a, const Image& b) {
    return count(a, [&](int x, int y) { return apart(a.pixel(x, y), b.pixel(x, y)) > 1.0 / 255; });
}
int different(const Image& a, const Image& b) {
    return count(a, [&](int x, int y) {
        return !std::equal(a.pixel(x, y), a.pixel(x, y) + 3, b.pixel(x, y));
    });
}
int not_uniform(const Image& a) {
    return count(a, [&](int x, int y) { return apart(a.pixel(x, y), a.pixel(0, 0)) > 1.0 / 255; });
}
int wrong(const Image& a, const Color& everywhere) {
    const double c[3] = {everywhere.x, everywhere.y, everywhere.z};
    return count(a, [&](int x, int y) { return apart(a.pixel(x, y), c) > 1.0 / 255; });
}

}  // namespace lancer::extremes
