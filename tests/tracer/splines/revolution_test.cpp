#include "tracer/splines/revolution.h"

#include <gtest/gtest.h>

#include <random>

namespace lancer::splines {
namespace {

using Wide = long double;

std::vector<Vec2d> times(std::vector<Vec2d> points, double factor) {
    for (Vec2d& p : points) p *= factor;
    return points;
}

const std::vector<Vec2d> vase{{0, 0},     {0.9, 0},   {1.1, 0.5}, {0.6, 1.0},
                              {0.1, 1.5}, {0.8, 1.9}, {0, 2}};
const std::vector<Vec2d> spindle{{0, -1}, {0.7, -0.2}, {0.3, 0.1}, {0.9, 0.5}, {0, 1}};
const std::vector<Vec2d> ring{{1, 0}, {1.4, 0}, {1.4, 0.5}, {1, 0.5}, {0.6, 0.5}, {0.6, 0}, {1, 0}};
const std::vector<Vec2d> wavy{{0.5, -1},  {0.5, 0}, {1, 0.5}, {0.2, 1},
                              {0.9, 1.5}, {0.4, 2}, {0.4, 3}};

struct Subject {
    const char* name;
    Spline spline;
    std::vector<Vec2d> profile;
};
const std::vector<Subject> subjects{{"vase", Spline::bezier, vase},
                                    {"spindle", Spline::linear, spindle},
                                    {"ring", Spline::bezier, ring},
                                    {"open catmull", Spline::catmull_rom, wavy},
                                    {"open bspline", Spline::bspline, wavy}};

struct Line {
    Vec3d origin;
    Vec3d dir;
};

class Lines {
  public:
    /// Through the middle of the surface, from any side.
    Line next(double factor) {
        const auto point = [&](double reach) {
            return Vec3d(place_(generator_), place_(generator_), place_(generator_)) * reach;
        };
        const Vec3d to = point(1.0) + Vec3d(0, 0.5, 0);
        const Vec3d from = point(5.0);
        return {from * factor, (to - from) * factor};
    }

  private:
    std::mt19937 generator_{3};
    std::uniform_real_distribution<double> place_{-1, 1};
};

Vec2<Wide> wide_point(const PlaneCurve& curve, std::size_t segment, Wide s) {
    const auto c = curve.segment(segment);
    const auto at = [&](std::size_t i) { return Vec2<Wide>(c[i].x, c[i].y); };
    if (curve.degree == 1) return evaluate(std::array{at(0), at(1)}, s).first;
    return evaluate(std::array{at(0), at(1), at(2), at(3)}, s).first;
}

/// Distance of the point at t from the surface near parameter s: golden search in wide arithmetic.
Wide distance(const PlaneCurve& curve, const Line& line, const CurveCrossing<double>& hit) {
    const Wide x = line.origin.x + static_cast<Wide>(hit.t) * line.dir.x;
    const Wide y = line.origin.y + static_cast<Wide>(hit.t) * line.dir.y;
    const Wide z = line.origin.z + static_cast<Wide>(hit.t) * line.dir.z;
    const Wide r = std::sqrt(x * x + z * z);
    const auto away = [&](Wide s) {
        const Vec2<Wide> p = wide_point(curve, hit.segment, s);
        return std::hypot(p.x - r, p.y - y);
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

/// The number of crossings, by dense sampling of the elimination's sign in wide arithmetic.
int count_by_sampling(const PlaneCurve& curve, const Line& line) {
    int count = 0;
    for (std::size_t i = 0; i < curve.segments(); ++i) {
        bool last = false;
        for (int k = 0; k <= 3000; ++k) {
            const Vec2<Wide> p = wide_point(curve, i, k / 3000.0L);
            const Wide t = (p.y - line.origin.y) / line.dir.y;
            const Wide x = line.origin.x + t * line.dir.x;
            const Wide z = line.origin.z + t * line.dir.z;
            const bool inside = x * x + z * z < p.x * p.x;
            if (k > 0) count += inside != last;
            last = inside;
        }
    }
    return count;
}

TEST(Revolution, CrossingsLieOnTheTrueSurfaceAtAnyScale) {
    for (const Subject& subject : subjects) {
        for (const double factor : {1.0, 1e9, 1e-9, 1e90, 1e-90}) {
            const PlaneCurve curve = profile_curve(subject.spline, times(subject.profile, factor));
            const auto surface = make_revolution<double>(curve);
            Lines lines;
            int hits = 0;
            for (int i = 0; i < 2000; ++i) {
                const Line line = lines.next(factor);
                for (const auto& hit : crossings(surface, line.origin, line.dir, 0.0)) {
                    ++hits;
                    EXPECT_LT(distance(curve, line, hit), 1e-14 * factor) << subject.name << i;
                }
            }
            EXPECT_GT(hits, 500) << subject.name;
        }
    }
}

TEST(Revolution, EveryCrossingIsFound) {
    for (const Subject& subject : subjects) {
        const PlaneCurve curve = profile_curve(subject.spline, subject.profile);
        const auto surface = make_revolution<double>(curve);
        Lines lines;
        int different = 0;
        for (int i = 0; i < 1000; ++i) {
            const Line line = lines.next(1);
            const int sampled = count_by_sampling(curve, line);
            const auto found = crossings(surface, line.origin, line.dir, 0.0);
            // Sampling misses pairs closer than its step; it never sees too many.
            EXPECT_GE(static_cast<int>(found.size()), sampled) << subject.name << " " << i;
            different += static_cast<int>(found.size()) != sampled;
            EXPECT_TRUE(std::ranges::is_sorted(found, {}, [](const auto& h) { return h.t; }));
        }
        EXPECT_LE(different, 3) << subject.name;
    }
}

TEST(Revolution, ErrorBoundsHold) {
    for (const Subject& subject : subjects) {
        const PlaneCurve curve = profile_curve(subject.spline, subject.profile);
        const auto rough = make_revolution<double>(curve);
        const auto fine = make_revolution<long double>(curve);
        Lines lines;
        int compared = 0;
        for (int i = 0; i < 5000; ++i) {
            const Line line = lines.next(1);
            const auto a = crossings(rough, line.origin, line.dir, 0.0);
            const auto b =
                crossings(fine, convert<Wide>(line.origin), convert<Wide>(line.dir), 0.0L);
            if (a.size() != b.size()) continue;
            for (std::size_t k = 0; k < a.size(); ++k, ++compared) {
                EXPECT_LE(std::abs(static_cast<Wide>(a[k].t) - b[k].t), a[k].error) << subject.name;
                EXPECT_LT(a[k].error, 1e-6);
            }
        }
        EXPECT_GT(compared, 1000);
    }
}

TEST(Revolution, BodiesAreEnteredAsOftenAsLeftAndAgreeWithContainment) {
    for (const Subject& subject : subjects) {
        const auto surface =
            make_revolution<double>(profile_curve(subject.spline, subject.profile));
        if (!surface.encloses) continue;
        Lines lines;
        for (int i = 0; i < 20000; ++i) {
            const Line line = lines.next(1);
            const auto found = crossings(surface, line.origin, line.dir, 0.0);
            ASSERT_EQ(found.size() % 2, 0u);
            for (std::size_t k = 0; k < found.size(); ++k) EXPECT_EQ(found[k].entering, k % 2 == 0);
            for (std::size_t k = 0; k + 1 < found.size(); ++k) {
                if (found[k + 1].t - found[k].t < 1e-12) continue;
                const double t = (found[k].t + found[k + 1].t) / 2;
                EXPECT_EQ(contains(surface, line.origin + t * line.dir), k % 2 == 0)
                    << subject.name << i;
            }
        }
    }
}

TEST(Revolution, SpecialDirections) {
    // A unit ball's polygon: from pole to pole through (1, 0).
    const auto cone = make_revolution<double>(
        profile_curve(Spline::linear, std::vector<Vec2d>{{0, -1}, {1, 0}, {0, 1}}));
    const auto ts = [&](const Vec3d& o, const Vec3d& d) {
        std::vector<double> t;
        for (const auto& c : crossings(cone, o, d, 0.0)) t.push_back(c.t);
        return t;
    };
    using List = std::vector<double>;
    EXPECT_EQ(ts({0, 5, 0}, {0, -1, 0}), (List{4, 6}));        // along the axis
    EXPECT_EQ(ts({0.5, 5, 0}, {0, -1, 0}), (List{4.5, 5.5}));  // parallel to it
    EXPECT_EQ(ts({5, 0.5, 0}, {-1, 0, 0}), (List{4.5, 5.5}));  // level, through it
    EXPECT_EQ(ts({5, 0, 0}, {-1, 0, 0}), (List{4, 6}));        // level, through the joint
    EXPECT_EQ(ts({5, 0, 2}, {-1, 0, 0}), List{});
    EXPECT_EQ(ts({1, 5, 0}, {0, -1, 0}).size() % 2, 0u);  // touching the widest circle
    EXPECT_EQ(ts({5, 1, 0}, {-1, 0, 0}).size() % 2, 0u);  // touching the pole
    EXPECT_EQ(ts({-1, -1, 0}, {1, 1, 0}).size() % 2, 0u);
    EXPECT_EQ(ts({-2, -1, 0}, {1, 1, 0}).size() % 2, 0u);  // along a side
}

TEST(Revolution, NearlyLevelRaysAgreeWithLevelOnes) {
    for (const Subject& subject : subjects) {
        const PlaneCurve curve = profile_curve(subject.spline, subject.profile);
        const auto surface = make_revolution<double>(curve);
        for (const double y : {-0.3, 0.2, 0.45, 0.8, 1.3}) {
            for (const double z : {0.0, 0.1, 0.3}) {
                const auto level = crossings(surface, {-3, y, z}, {1, 0, 0}, 0.0);
                for (double slope = 1e-6; slope > 1e-30; slope /= 10) {
                    const Line line{{-3, y - 3 * slope, z}, {1, slope, 0}};
                    const auto found = crossings(surface, line.origin, line.dir, 0.0);
                    ASSERT_EQ(found.size(), level.size()) << subject.name << y << " " << slope;
                    for (std::size_t i = 0; i < found.size(); ++i) {
                        EXPECT_NEAR(found[i].t, level[i].t, 100 * slope + 1e-13);
                        EXPECT_LT(distance(curve, line, found[i]), 1e-13);
                    }
                }
            }
        }
    }
}

TEST(Revolution, NoRayPassesAJointOrAPole) {
    // Rays aimed at joints, at any zoom: what enters leaves.
    const auto surface = make_revolution<double>(profile_curve(Spline::linear, spindle));
    std::mt19937 generator(9);
    std::uniform_real_distribution<double> place(-1, 1);
    for (int i = 0; i < 100000; ++i) {
        const Vec2d joint = spindle[static_cast<std::size_t>(i) % spindle.size()];
        const double angle = pi * place(generator);
        const double zoom = std::pow(10.0, -7 * (place(generator) + 1));
        const Vec3d target(joint.x * std::cos(angle) + zoom * place(generator),
                           joint.y + zoom * place(generator), joint.x * std::sin(angle));
        const Vec3d from(5 * place(generator), 5 * place(generator), 5 * place(generator));
        const auto found = crossings(surface, from, target - from, 0.0);
        ASSERT_EQ(found.size() % 2, 0u);
    }
}

TEST(Revolution, FarAwayRaysStillMeetIt) {
    const PlaneCurve curve = profile_curve(Spline::bezier, vase);
    const auto surface = make_revolution<double>(curve);
    for (double far = 10; far < 1e12; far *= 10) {
        const Line line{{0.3 * far, far + 1, 0.1 * far}, {-0.3, -1, -0.1}};
        const auto found = crossings(surface, line.origin, line.dir, 0.0);
        ASSERT_GE(found.size(), 2u) << far;
        for (const auto& hit : found) EXPECT_LT(distance(curve, line, hit), 1e-15 * far);
    }
}

}  // namespace
}  // namespace lancer::splines
