// Lathes, prisms and patches compared with 256-bit arithmetic: Newton's method continues from the
// kernel's result to the true crossing. Cases in which it does not converge there (tangents, cusps)
// are left out and counted.
#include "tests/oracle/tally.h"
#include "tracer/rays/crossing.h"
#include "tracer/rays/surface_point.h"
#include "tracer/shapes/bicubic.h"
#include "tracer/shapes/lathe.h"
#include "tracer/shapes/prism.h"

namespace lancer::oracle {
namespace {

/// Point and slope of a curve's segment, exactly.
struct ExactCurve {
    std::vector<std::array<Exact, 2>> points;

    ExactCurve(const splines::Curve<double>& curve, std::uint32_t segment) {
        for (std::size_t i = 0; i <= curve.degree; ++i) {
            const Vec2d& p = curve.segment(segment)[i];
            points.push_back(
                {ldexp(Exact(p.x), curve.exponent), ldexp(Exact(p.y), curve.exponent)});
        }
    }
    /// Value and derivative of coordinate `k`.
    std::pair<Exact, Exact> at(std::size_t k, const Exact& s) const {
        if (points.size() == 2) return splines::evaluate(std::array{points[0][k], points[1][k]}, s);
        return splines::evaluate(std::array{points[0][k], points[1][k], points[2][k], points[3][k]},
                                 s);
    }
};

/// Newton's method for two equations: `equations(t, s)` gives their values and slopes, {f, df/dt,
/// df/ds} each. Returns false when it does not settle.
template <class Equations>
bool settle(Exact& t, Exact& s, Equations&& equations) {
    Exact step = 1;
    for (int i = 0; i < 30; ++i) {
        const auto [f, g] = equations(t, s);
        const Exact det = f[1] * g[2] - f[2] * g[1];
        if (det == 0) return false;
        const Exact dt = (f[0] * g[2] - f[2] * g[0]) / det;
        const Exact ds = (f[1] * g[0] - f[0] * g[1]) / det;
        // Far steps lead to other crossings.
        if (abs(ds) > Exact(1e-3)) return false;
        t -= dt;
        s -= ds;
        step = abs(ds);
        if (step < Exact(1e-50)) return true;
    }
    return false;
}

using Row = std::array<Exact, 3>;

constexpr Spline curves[] = {Spline::linear, Spline::bezier, Spline::bspline, Spline::catmull_rom};

TEST(Oracle, Lathe) {
    Tally tally("lathe");
    std::uint64_t undecided = 0;
    std::uint64_t found = 0;
    tally.run([&](Draw& draw) {
        const double size = draw.decade(-3, 3);
        std::vector<Vec2d> profile;
        for (int i = 0; i < 4; ++i)
            profile.emplace_back(size * draw.between(0.1, 1), size * (i + draw.between(0, 1)) / 3);
        const auto surface =
            splines::make_revolution<double>(profile_curve(curves[draw.number() % 4], profile));
        const LatheSolid<double> lathe{&surface};
        const Ray<double> ray = draw.ray_at(Vec3d(0, size / 2, 0), size);
        for (const auto& c : splines::crossings(surface, ray.origin, ray.dir, 0.0)) {
            ++found;
            const ExactCurve curve(surface.curve, c.segment);
            const ExactVec o = exact(ray.origin);
            const ExactVec d = exact(ray.dir);
            Exact t = c.t;
            Exact s = c.s;
            const bool settled = settle(t, s, [&](const Exact& at, const Exact& on) {
                const auto [r, dr] = curve.at(0, on);
                const auto [y, dy] = curve.at(1, on);
                const ExactVec p = o + at * d;
                return std::pair{Row{p.x * p.x + p.z * p.z - r * r, 2 * (p.x * d.x + p.z * d.z),
                                     Exact(-2 * r * dr)},
                                 Row{p.y - y, d.y, Exact(-dy)}};
            });
            if (!settled) {
                ++undecided;
                continue;
            }
            const Crossing<double> crossing{c.t, c.error, c.segment, c.entering};
            tally.hit(ray, crossing, t, size);
            const SurfacePoint<double> p = surface_point(lathe, ray, c.t, c.segment);
            // Near the crossing, the surface equals its tangent plane.
            const ExactVec at = o + t * d;
            const Exact r = sqrt(at.x * at.x + at.z * at.z);
            const Exact dr = curve.at(0, s).second;
            const Exact dy = curve.at(1, s).second;
            const ExactVec normal = unit_of({dy * at.x / r, Exact(-dr), dy * at.z / r});
            const ExactVec n = dot(normal, exact(p.normal)) < 0 ? Exact(-1) * normal : normal;
            tally.point(p, dot(n, exact(p.anchor) + exact(p.offset) - at), n, size);
        }
    });
    EXPECT_LT(static_cast<double>(undecided), 0.01 * static_cast<double>(found));
    tally.report(5000);
}

TEST(Oracle, Prism) {
    Tally tally("prism");
    std::uint64_t undecided = 0;
    std::uint64_t found = 0;
    tally.run([&](Draw& draw) {
        const double size = draw.decade(-3, 3);
        std::vector<Vec2d> outline;
        for (int i = 0; i < 6; ++i) {
            const double angle = tau * (i + draw.between(0, 0.8)) / 6;
            outline.push_back(size * draw.between(0.4, 1) *
                              Vec2d(std::cos(angle), std::sin(angle)));
        }
        const auto surface = splines::make_extrusion<double>(
            outline_curve(curves[draw.number() % 4], outline), -size / 2, size / 2, true);
        const PrismSolid<double> prism{&surface};
        const Ray<double> ray = draw.ray_at(Vec3d(0.0), size);
        for (const auto& c : splines::crossings(surface, ray.origin, ray.dir, 0.0)) {
            if (c.segment >= surface.curve.segments()) continue;  // caps are planes
            ++found;
            const ExactCurve curve(surface.curve, c.segment);
            const ExactVec o = exact(ray.origin);
            const ExactVec d = exact(ray.dir);
            Exact t = c.t;
            Exact s = c.s;
            const bool settled = settle(t, s, [&](const Exact& at, const Exact& on) {
                const auto [x, dx] = curve.at(0, on);
                const auto [z, dz] = curve.at(1, on);
                return std::pair{Row{o.x + at * d.x - x, d.x, Exact(-dx)},
                                 Row{o.z + at * d.z - z, d.z, Exact(-dz)}};
            });
            if (!settled) {
                ++undecided;
                continue;
            }
            const Crossing<double> crossing{c.t, c.error, c.segment, c.entering};
            tally.hit(ray, crossing, t, size);
            const SurfacePoint<double> p = surface_point(prism, ray, c.t, c.segment);
            const ExactVec normal =
                unit_of({curve.at(1, s).second, 0, Exact(-curve.at(0, s).second)});
            const ExactVec n = dot(normal, exact(p.normal)) < 0 ? Exact(-1) * normal : normal;
            tally.point(p, dot(n, exact(p.anchor) + exact(p.offset) - (o + t * d)), n, size);
        }
    });
    EXPECT_LT(static_cast<double>(undecided), 0.01 * static_cast<double>(found));
    tally.report(5000);
}

/// Point and both derivatives of a bicubic Bezier patch, exactly.
std::array<ExactVec, 3> patch_at(const std::vector<Vec3d>& control, const Exact& u,
                                 const Exact& v) {
    std::array<std::array<ExactVec, 4>, 2> rows;  // values and slopes along u
    for (std::size_t i = 0; i < 4; ++i) {
        for (int k = 0; k < 3; ++k) {
            const auto number = [&](std::size_t j) { return Exact(control[4 * i + j][k]); };
            const auto [value, slope] =
                splines::evaluate(std::array{number(0), number(1), number(2), number(3)}, u);
            (k == 0 ? rows[0][i].x : k == 1 ? rows[0][i].y : rows[0][i].z) = value;
            (k == 0 ? rows[1][i].x : k == 1 ? rows[1][i].y : rows[1][i].z) = slope;
        }
    }
    const auto [value, along_v] = splines::evaluate(rows[0], v);
    return {value, splines::evaluate(rows[1], v).first, along_v};
}

TEST(Oracle, Patch) {
    Tally tally("patch");
    std::uint64_t undecided = 0;
    std::uint64_t found = 0;
    tally.run([&](Draw& draw) {
        // Preparing a patch costs far more than intersecting it, so each one is tested with sixteen
        // rays.
        if (draw.number() % 16 != 0) return;
        const double size = draw.decade(-3, 3);
        Patch patch;
        for (int i = 0; i < 4; ++i) {
            for (int j = 0; j < 4; ++j)
                patch.control.push_back(size * Vec3d(j + draw.between(-0.3, 0.3),
                                                     draw.between(-1, 1),
                                                     i + draw.between(-0.3, 0.3)));
        }
        const BicubicSurface<double> surface(patch, 0);
        const BicubicSolid<double> solid{&surface};
        for (int i = 0; i < 16; ++i) {
            const Ray<double> ray = draw.ray_at(size * Vec3d(1.5, 0, 1.5), size);
            const auto crossing = [&](const Crossing<double>& c, double pu, double pv) {
                ++found;
                const auto& piece = surface.tree().pieces[c.face];
                Exact u = Exact(piece.u0) + Exact(piece.du) * pu;
                Exact v = Exact(piece.v0) + Exact(piece.dv) * pv;
                Exact t = c.t;
                const ExactVec o = exact(ray.origin);
                const ExactVec d = exact(ray.dir);
                bool settled = false;
                for (int k = 0; k < 30 && !settled; ++k) {
                    const auto [p, du, dv] = patch_at(patch.control, u, v);
                    const ExactVec f = p - (o + t * d);
                    const Exact det = dot(du, cross(dv, d));
                    if (det == 0) break;
                    const Exact step_u = dot(f, cross(dv, d)) / det;
                    const Exact step_v = dot(du, cross(f, d)) / det;
                    if (abs(step_u) + abs(step_v) > Exact(1e-3)) break;
                    u -= step_u;
                    v -= step_v;
                    t += dot(du, cross(dv, f)) / det;
                    settled = abs(step_u) + abs(step_v) < Exact(1e-50);
                }
                if (!settled) {
                    ++undecided;
                    return false;
                }
                tally.hit(ray, c, t, size);
                const SurfacePoint<double> p = bicubic_point(solid, c.face, pu, pv);
                const auto [truth, du, dv] = patch_at(patch.control, u, v);
                const ExactVec n = unit_of(cross(du, dv));
                tally.point(p, dot(n, exact(p.anchor) + exact(p.offset) - truth), n, size);
                return false;
            };
            crossings(solid, ray, IntersectionHints{}, whole_line<double>(), crossing);
        }
    });
    EXPECT_LT(static_cast<double>(undecided), 0.01 * static_cast<double>(found));
    tally.report(5000);
}

}  // namespace
}  // namespace lancer::oracle
