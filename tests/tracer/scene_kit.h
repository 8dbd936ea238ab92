// Small scenes for tests, and the colour that one ray brings back from them.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <utility>

#include "tracer/render.h"

namespace lancer::kit {

inline std::uint32_t add(Scene& scene, const Material& material) {
    scene.materials.push_back(material);
    return static_cast<std::uint32_t>(scene.materials.size() - 1);
}
inline std::uint32_t add(Scene& scene, const Affine<double>& transform) {
    scene.transforms.push_back(transform);
    return static_cast<std::uint32_t>(scene.transforms.size() - 1);
}
inline Object& show(Scene& scene, const Shape& shape, std::uint32_t material = 0,
                    const Affine<double>& transform = {}) {
    Object object;
    object.shape = shape;
    object.material = material;
    object.transform = transform == Affine<double>{} ? 0 : add(scene, transform);
    return scene.objects.emplace_back(object);
}
inline Object& show(Scene& scene, const Shape& shape, const Material& material,
                    const Affine<double>& transform = {}) {
    return show(scene, shape, add(scene, material), transform);
}

inline Affine<double> shift(double x, double y, double z) {
    Affine<double> map;
    map.shift = {x, y, z};
    return map;
}
inline Affine<double> stretched(double x, double y, double z) {
    return {{Vec3d(x, 0, 0), Vec3d(0, y, 0), Vec3d(0, 0, z)}, Vec3d(0.0)};
}
inline Affine<double> turn_x(double degrees) {
    const auto [s, c] = elementary::sine_cosine_of_degrees(degrees);
    return {{Vec3d(1, 0, 0), Vec3d(0, c, -s), Vec3d(0, s, c)}, Vec3d(0.0)};
}
inline Affine<double> turn_y(double degrees) {
    const auto [s, c] = elementary::sine_cosine_of_degrees(degrees);
    return {{Vec3d(c, 0, s), Vec3d(0, 1, 0), Vec3d(-s, 0, c)}, Vec3d(0.0)};
}
inline Affine<double> turn_z(double degrees) {
    const auto [s, c] = elementary::sine_cosine_of_degrees(degrees);
    return {{Vec3d(c, -s, 0), Vec3d(s, c, 0), Vec3d(0, 0, 1)}, Vec3d(0.0)};
}
/// Applied in the order written, as in a script.
template <class... Maps>
Affine<double> in_turn(const Affine<double>& first, const Maps&... more) {
    Affine<double> map = first;
    ((map = compose(more, map)), ...);
    return map;
}

/// An orthographic or perspective camera that looks along the line, its centre ray exactly on it.
inline Camera camera_along(const Vec3d& from, const Vec3d& at) {
    Camera camera;
    camera.position = from;
    camera.look_at = at;
    const Vec3d d = normalize(at - from);
    camera.up = std::abs(d.y) > 0.9 ? Vec3d(0, 0, 1) : Vec3d(0, 1, 0);
    return camera;
}

/// What one ray brings back; media_lost must stay 0, which this checks by a picture of one pixel.
inline Color seen(Scene scene, const Vec3d& from, const Vec3d& at) {
    scene.cameras = {camera_along(from, at)};
    RayCounts counts;
    const Image image = compile(scene, scene.settings)->render({0, 1, 1, {}, false}, {}, counts);
    EXPECT_EQ(counts.media_lost, 0U);
    return {image.pixel(0, 0)[0], image.pixel(0, 0)[1], image.pixel(0, 0)[2]};
}

inline Image picture(const Scene& scene, int width, int height, RayCounts* counts = nullptr) {
    Settings settings = scene.settings;
    settings.threads = 1;
    RayCounts own;
    Image image = compile(scene, settings)->render({0, width, height, {}, false}, {}, own);
    if (counts != nullptr) *counts = own;
    return image;
}

/// Glass that neither dims nor mirrors.
inline Material clear(double ior) {
    Material m;
    m.ambient = 0;
    m.diffuse = 0;
    m.transmission = 1;
    m.ior = ior;
    return m;
}

/// A surface that shows its colour as it is, lit or not.
inline Material glowing(const Color& color) {
    Material m;
    m.color = color;
    m.ambient = 0;
    m.diffuse = 0;
    m.emission = Color(1);
    return m;
}

#define EXPECT_COLOR_NEAR(actual, expected, bound)                       \
    do {                                                                 \
        const ::lancer::Color actual_color = (actual);                   \
        const ::lancer::Color expected_color = (expected);               \
        EXPECT_NEAR(actual_color.x, expected_color.x, bound) << "red";   \
        EXPECT_NEAR(actual_color.y, expected_color.y, bound) << "green"; \
        EXPECT_NEAR(actual_color.z, expected_color.z, bound) << "blue";  \
    } while (false)

}  // namespace lancer::kit
