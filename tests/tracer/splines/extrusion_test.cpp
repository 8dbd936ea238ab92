#include "tracer/splines/extrusion.h"

#include <gtest/gtest.h>

#include <random>

namespace lancer::splines {
namespace {

using Wide = long double;

struct Subject {
    const char* name;
    Spline spline;
    std::vector<Vec2d> outline;
};
const std::vector<Vec2d> star{{1, 0},    {0.3, 0.2},   {0.2, 1},  {-0.2, 0.4},
                              {-1, 0.5}, {-0.4, -0.2}, {0, -1.1}, {0.3, -0.3}};
const std::vector<Subject> subjects{
    {"star", Spline::linear, star},
    {"blob", Spline::bspline, star},
    {"wave", Spline::catmull_rom, star},
    {"leaf",
     Spline::bezier,
     {{-1, 0}, {-0.5, 1.5}, {0.5, 0.5}, {1, 0}, {0.5, -0.5}, {-0.5, -0.2}}}};

std::vector<Vec2d> times(std::vector<Vec2d> points, double factor) {
    for (Vec2d& p : points) p *= factor;
    return points;
}

struct Line {
    Vec3d origin;
    Vec3d dir;
};

class Lines {
  public:
    Line next(double factor) {
        const auto point = [&](double reach) {
            return Vec3d(place_(generator_), place_(generator_), place_(generator_)) * reach;
        };
        const Vec3d to = point(0.8);
        const Vec3d from = point(5.0);
        return {from * factor, (to - from) * factor};
    }

  private:
    std::mt19937 generator_{4};
    std::uniform_real_distribution<double> place_{-1, 1};
};

/// Distance of the point at t from the outline near parameter s, or from the cap's plane.
Wide distance(const PlaneCurve& curve, double bottom, double top, const Line& line,
              const CurveCrossing<double>& hit) {
    const auto at = [&](int axis) {
        return line.origin[axis] + static_cast<Wide>(hit.t) * line.dir[axis];
    };
    if (hit.segment == curve.segments()) return std::abs(at(1) - bottom);
    if (hit.segment == curve.segments() + 1) return std::abs(at(1) - top);
    const auto c = curve.segment(hit.segment);
    const auto away = [&](Wide s) {
        const Wide r = 1 - s;
        const auto p = [&](int axis) -> Wide {
            if (curve.degree == 1) return c[0][axis] * r + c[1][axis] * s;
            return c[0][axis] * r * r * r + 3 * c[1][axis] * r * r * s +
                   3 * c[2][axis] * r * s * s + c[3][axis] * s * s * s;
        };
        return std::hypot(p(0) - at(0), p(1) - at(2));
    };
    Wide low = std::max<Wide>(0, hit.s - 1e-5L);
    Wide high = std::min<Wide>(1, hit.s + 1e-5L);
    for (int i = 0; i < 100; ++i) {
        const Wide a = low + (high - low) * 0.382L;
        const Wide b = low + (high - low) * 0.618L;
        (away(a) < away(b) ? high : low) = away(a) < away(b) ? b : a;
    }
    return std::min(away(low), away(hit.s));
}

TEST(Extrusion, CrossingsLieOnTheTrueSurfaceAtAnyScale) {
    for (const Subject& subject : subjects) {
        for (const double factor : {1.0, 1e9, 1e-9, 1e90, 1e-90}) {
            const PlaneCurve curve = outline_curve(subject.spline, times(subject.outline, factor));
            const double bottom = -0.6 * factor;
            const double top = 0.5 * factor;
            const auto solid = make_extrusion<double>(curve, bottom, top, true);
            Lines lines;
            int sides = 0;
            int caps = 0;
            for (int i = 0; i < 2000; ++i) {
                const Line line = lines.next(factor);
                const auto found = crossings(solid, line.origin, line.dir, 0.0);
                ASSERT_EQ(found.size() % 2, 0u);
                for (std::size_t k = 0; k < found.size(); ++k) {
                    EXPECT_EQ(found[k].entering, k % 2 == 0);
                    EXPECT_LT(distance(curve, bottom, top, line, found[k]), 1e-14 * factor)
                        << subject.name << i;
                    (found[k].segment < curve.segments() ? sides : caps) += 1;
                    if (k == 0 || found[k].t - found[k - 1].t < 1e-12) continue;
                    const double t = (found[k].t + found[k - 1].t) / 2;
                    EXPECT_EQ(contains(solid, line.origin + t * line.dir), k % 2 == 1);
                }
            }
            EXPECT_GT(sides, 300) << subject.name;
            EXPECT_GT(caps, 300) << subject.name;
        }
    }
}

TEST(Extrusion, ErrorBoundsHold) {
    for (const Subject& subject : subjects) {
        const PlaneCurve curve = outline_curve(subject.spline, subject.outline);
        const auto rough = make_extrusion<double>(curve, -0.6, 0.5, true);
        const auto fine = make_extrusion<long double>(curve, -0.6, 0.5, true);
        Lines lines;
        int compared = 0;
        for (int i = 0; i < 5000; ++i) {
            const Line line = lines.next(1);
            const auto a = crossings(rough, line.origin, line.dir, 0.0);
            const auto b =
                crossings(fine, convert<Wide>(line.origin), convert<Wide>(line.dir), 0.0L);
            if (a.size() != b.size()) continue;
            for (std::size_t k = 0; k < a.size(); ++k, ++compared) {
                if (a[k].segment != b[k].segment) continue;
                EXPECT_LE(std::abs(static_cast<Wide>(a[k].t) - b[k].t), a[k].error) << subject.name;
            }
        }
        EXPECT_GT(compared, 1000);
    }
}

TEST(Extrusion, StraightThroughAndAlong) {
    const auto cube = make_extrusion<double>(
        outline_curve(Spline::linear, std::vector<Vec2d>{{0, 0}, {1, 0}, {1, 1}, {0, 1}}), 0, 1,
        true);
    const auto ts = [&](const Vec3d& o, const Vec3d& d) {
        std::vector<double> t;
        for (const auto& c : crossings(cube, o, d, 0.0)) t.push_back(c.t);
        return t;
    };
    using List = std::vector<double>;
    EXPECT_EQ(ts({0.5, 5, 0.5}, {0, -1, 0}), (List{4, 5}));
    EXPECT_EQ(ts({1.5, 5, 0.5}, {0, -1, 0}), List{});
    EXPECT_EQ(ts({-2, 0.5, 0.5}, {2, 0, 0}), (List{1, 1.5}));
    EXPECT_EQ(ts({-2, 1.5, 0.5}, {2, 0, 0}), List{});
    EXPECT_EQ(ts({-1, -1, 0.5}, {1, 1, 0}), (List{1, 2}));  // from edge to edge
    const auto corners = ts({-1, -1, -1}, {1, 1, 1});       // from corner to corner
    ASSERT_EQ(corners.size(), 2u);
    EXPECT_DOUBLE_EQ(corners[0], 1);
    EXPECT_DOUBLE_EQ(corners[1], 2);
}

TEST(Extrusion, NoRayPassesASeam) {
    // Rays that end in the middle of the solid, aimed at edges and corners at any zoom: all enter
    // it.
    for (const Subject& subject : subjects) {
        const PlaneCurve curve = outline_curve(subject.spline, subject.outline);
        const auto solid = make_extrusion<double>(curve, -0.6, 0.5, true);
        std::mt19937 generator(6);
        std::uniform_real_distribution<double> place(-1, 1);
        const Vec3d middle(0.02, 0, 0.03);
        ASSERT_TRUE(contains(solid, middle));
        for (int i = 0; i < 50000; ++i) {
            const auto segment = static_cast<std::size_t>(i) % curve.segments();
            const Vec2d joint = curve.segment(segment)[0];
            const double zoom = std::pow(10.0, -8 * (place(generator) + 1));
            const Vec3d target(joint.x + zoom * place(generator), i % 3 == 0 ? -0.6 : 0.5,
                               joint.y + zoom * place(generator));
            const auto found = crossings(solid, target, middle - target, 0.0);
            int before = 0;
            for (const auto& c : found) before += c.t < 1;
            EXPECT_EQ(before % 2, 1) << subject.name;
        }
    }
}

TEST(Extrusion, TheSurfaceThatARayStartsOnIsNotMetAgain) {
    for (const Subject& subject : subjects) {
        const PlaneCurve curve = outline_curve(subject.spline, subject.outline);
        const auto solid = make_extrusion<double>(curve, -0.6, 0.5, true);
        Lines lines;
        int started = 0;
        for (int i = 0; i < 3000; ++i) {
            const Line line = lines.next(1);
            const auto found = crossings(solid, line.origin, line.dir, 0.0);
            for (std::size_t k = 0; k < found.size(); ++k) {
                const Vec3d start = line.origin + found[k].t * line.dir;
                const auto rest =
                    crossings(solid, start, line.dir, 1e-15, {found[k].segment, found[k].entering});
                ASSERT_EQ(rest.size() + 1, found.size()) << subject.name << i;
                for (std::size_t j = 0; j < rest.size(); ++j) {
                    const std::size_t same = j < k ? j : j + 1;
                    EXPECT_EQ(rest[j].segment, found[same].segment);
                    EXPECT_NEAR(rest[j].t, found[same].t - found[k].t, 1e-9);
                }
                ++started;
            }
        }
        EXPECT_GT(started, 1000);
    }
}

}  // namespace
}  // namespace lancer::splines
