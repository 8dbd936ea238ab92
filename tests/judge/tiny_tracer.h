// A ray tracer of a hundred lines for tests of the judge: spheres over a chequered plane, one lamp,
// shadows, a mirror and glass. It shares nothing with the tracer that is judged elsewhere.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "judge/explain/probe_function.h"
#include "model/image.h"
#include "model/math.h"

namespace lancer::judge::tiny {

struct Ball {
    Vec3d center{0, 0, 0};
    double radius = 1;
    Color color{1, 1, 1};
    double mirror = 0;
    double ior = 0;  ///< 0: opaque
    bool inside_out = false;
};

struct World {
    int width = 160;
    int height = 120;
    double shift_x = 0;  ///< of the camera, pixels
    double shift_y = 0;
    std::vector<Ball> balls = {{{-1.1, 1, 0.3}, 1, {0.8, 0.3, 0.2}, 0, 0, false},
                               {{1.15, 0.8, 0.6}, 0.8, {0.2, 0.2, 0.3}, 0.6, 0, false},
                               {{0.2, 0.55, 1.9}, 0.55, {0.05, 0.05, 0.05}, 0, 1.5, false}};
    Vec3d lamp{4, 6, 5};
    double brightness = 1;
    double cell = 0.5;
    double texture_offset = 0.013;
    double gamma = 1;
};

class Tracer {
  public:
    explicit Tracer(const World& world) : world_(world) {}

    Probe probe(double x, double y) const {
        Probe sample;
        sample.rays = 1;
        const double aspect = static_cast<double>(world_.width) / world_.height;
        const double sx = ((x + world_.shift_x) / world_.width - 0.5) * aspect;
        const double sy = 0.5 - (y + world_.shift_y) / world_.height;
        const Ray ray{{0.05, 1.6, 6.5}, normalize(Vec3d{sx, sy - 0.12, -1.25})};
        sample.color = trace(ray, 0, sample);
        for (int c = 0; c < 3; ++c) {
            sample.color[c] = std::pow(std::min(sample.color[c], 1.0), world_.gamma);
        }
        return sample;
    }

    /// As a 16-bit file would hold it when `bits` is set.
    Image render(bool bits = false) const {
        Image image(world_.width, world_.height);
        for (int y = 0; y < world_.height; ++y) {
            for (int x = 0; x < world_.width; ++x) {
                const Color color = probe(x + 0.5, y + 0.5).color;
                for (int c = 0; c < 3; ++c) {
                    image.pixel(x, y)[c] =
                        bits ? std::floor(color[c] * 65535 + 0.5) / 65535 : color[c];
                }
            }
        }
        return image;
    }

  private:
    struct Ray {
        Vec3d origin, direction;
    };
    static constexpr std::uint32_t floor_id = 1000;
    static constexpr std::uint32_t nothing = 2000;
    struct Hit {
        double t = 1e30;
        std::uint32_t object = nothing;
        Vec3d point{0, 0, 0}, normal{0, 0, 0};
    };

    Hit nearest(const Ray& ray) const {
        constexpr double least = 1e-7;
        Hit hit;
        for (std::uint32_t i = 0; i < world_.balls.size(); ++i) {
            const Ball& ball = world_.balls[i];
            const Vec3d f = ray.origin - ball.center;
            const double b = dot(f, ray.direction);
            const Vec3d side = f - b * ray.direction;
            const double d = ball.radius * ball.radius - dot(side, side);
            if (d < 0) continue;
            const double root = std::sqrt(d);
            const double t = -b - root > least ? -b - root : -b + root;
            if (t > least && t < hit.t) hit = {t, i, {}, {}};
        }
        if (ray.direction.y < 0) {
            const double t = -ray.origin.y / ray.direction.y;
            if (t > least && t < hit.t) hit = {t, floor_id, {}, {}};
        }
        if (hit.object == nothing) return hit;
        hit.point = ray.origin + hit.t * ray.direction;
        hit.normal = {0, 1, 0};
        if (hit.object != floor_id) {
            const Ball& ball = world_.balls[hit.object];
            hit.normal = (hit.point - ball.center) / ball.radius;
            if (ball.inside_out) hit.normal = -hit.normal;
        }
        return hit;
    }

    Color trace(const Ray& ray, int level, Probe& sample) const {
        if (level > 4) return {0, 0, 0};
        const Hit hit = nearest(ray);
        sample.path = sample.path * 1000003 + hit.object + 1;
        if (level == 0) {
            sample.object = hit.object;
            sample.depth = hit.object == nothing ? 0 : hit.t;
            sample.normal = hit.normal;
        }
        if (hit.object == nothing) return Color{0.1, 0.15, 0.3} * (1 + 0.5 * ray.direction.y);
        Color surface =
            hit.object == floor_id ? checker(hit.point) : world_.balls[hit.object].color;
        const Vec3d to_lamp = world_.lamp - hit.point;
        const Vec3d l = normalize(to_lamp);
        const Ray shadow_ray{hit.point, l};
        const double cosine = dot(hit.normal, l);
        const bool lit = cosine > 0 && nearest(shadow_ray).t >= length(to_lamp);
        sample.path = sample.path * 31 + (lit ? 1 : 0);
        if (level == 0) sample.lit = lit ? 1 : 0;
        Color color = surface * (0.1 + (lit ? 0.8 * cosine * world_.brightness : 0.0));
        if (hit.object == floor_id) return color;
        const Ball& ball = world_.balls[hit.object];
        if (ball.mirror > 0) color += ball.mirror * trace(mirrored(ray, hit), level + 1, sample);
        if (ball.ior > 0) color += 0.9 * trace(refracted(ray, hit, ball.ior), level + 1, sample);
        return color;
    }

    static Ray mirrored(const Ray& ray, const Hit& hit) {
        return {hit.point, ray.direction - 2 * dot(ray.direction, hit.normal) * hit.normal};
    }

    static Ray refracted(const Ray& ray, const Hit& hit, double ior) {
        double cosine = -dot(ray.direction, hit.normal);
        const bool entering = cosine > 0;
        const Vec3d n = entering ? hit.normal : -hit.normal;
        const double eta = entering ? 1 / ior : ior;
        cosine = std::abs(cosine);
        const double k = 1 - eta * eta * (1 - cosine * cosine);
        if (k < 0) return mirrored(ray, hit);
        return {hit.point, eta * ray.direction + (eta * cosine - std::sqrt(k)) * n};
    }

    Color checker(const Vec3d& p) const {
        // Further off the cells would be smaller than what a pixel sees.
        if (dot(p, p) > 100) return {0.5, 0.5, 0.5};
        const double o = world_.texture_offset;
        const auto cell = static_cast<long>(std::floor((p.x + o) / world_.cell)) +
                          static_cast<long>(std::floor((p.z + o) / world_.cell));
        return cell % 2 == 0 ? Color{0.9, 0.9, 0.85} : Color{0.2, 0.25, 0.2};
    }

    World world_;
};

/// `world` as a ProbeFunction.
inline ProbeFunction probe_of(const World& world) {
    return [tracer = Tracer(world)](double x, double y) { return tracer.probe(x, y); };
}

}  // namespace lancer::judge::tiny
