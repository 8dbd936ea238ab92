#include "model/splines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace lancer {
namespace {

Vec2d bezier(std::span<const Vec2d> c, double s) {
    const double r = 1 - s;
    return c[0] * (r * r * r) + c[1] * (3 * r * r * s) + c[2] * (3 * r * s * s) +
           c[3] * (s * s * s);
}

Vec2d bspline(const std::vector<Vec2d>& p, std::size_t i, double s) {
    const double r = 1 - s;
    return (p[i] * (r * r * r) + p[i + 1] * (3 * s * s * s - 6 * s * s + 4) +
            p[i + 2] * (-3 * s * s * s + 3 * s * s + 3 * s + 1) + p[i + 3] * (s * s * s)) /
           6.0;
}

Vec2d catmull_rom(const std::vector<Vec2d>& p, std::size_t i, double s) {
    return (p[i + 1] * 2.0 + (p[i + 2] - p[i]) * s +
            (p[i] * 2.0 - p[i + 1] * 5.0 + p[i + 2] * 4.0 - p[i + 3]) * (s * s) +
            (p[i + 1] * 3.0 - p[i] - p[i + 2] * 3.0 + p[i + 3]) * (s * s * s)) *
           0.5;
}

void expect_near(const Vec2d& a, const Vec2d& b) {
    EXPECT_NEAR(a.x, b.x, 1e-14);
    EXPECT_NEAR(a.y, b.y, 1e-14);
}

std::vector<Vec2d> random_points(std::size_t n, unsigned seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> place(0, 1);
    std::vector<Vec2d> points;
    for (std::size_t i = 0; i < n; ++i) points.emplace_back(place(generator), place(generator));
    return points;
}

TEST(Splines, OpenCurvesAreTheirDefinitions) {
    const auto points = random_points(7, 1);
    const auto b = profile_curve(Spline::bspline, points);
    const auto c = profile_curve(Spline::catmull_rom, points);
    ASSERT_EQ(b.segments(), 4u);
    ASSERT_EQ(c.segments(), 4u);
    EXPECT_EQ(c.points.front(), points[1]);
    EXPECT_EQ(c.points.back(), points[5]);
    for (std::size_t i = 0; i < 4; ++i) {
        for (const double s : {0.0, 0.25, 0.7, 1.0}) {
            expect_near(bezier(b.segment(i), s), bspline(points, i, s));
            expect_near(bezier(c.segment(i), s), catmull_rom(points, i, s));
        }
    }
    EXPECT_EQ(profile_curve(Spline::bezier, points).segments(), 2u);
    EXPECT_EQ(profile_curve(Spline::linear, points).segments(), 6u);
}

TEST(Splines, OutlinesArePeriodic) {
    const auto points = random_points(6, 2);
    std::vector<Vec2d> wrapped{points.back()};
    wrapped.insert(wrapped.end(), points.begin(), points.end());
    wrapped.insert(wrapped.end(), points.begin(), points.end());
    for (const Spline spline :
         {Spline::linear, Spline::bezier, Spline::bspline, Spline::catmull_rom}) {
        const auto curve = outline_curve(spline, points);
        EXPECT_TRUE(curve.closed);
        EXPECT_EQ(curve.points.front(), curve.points.back());
        EXPECT_EQ(curve.segments(), spline == Spline::bezier ? 2u : 6u);
    }
    const auto b = outline_curve(Spline::bspline, points);
    const auto c = outline_curve(Spline::catmull_rom, points);
    for (std::size_t i = 0; i < 6; ++i) {
        expect_near(bezier(b.segment(i), 0.3), bspline(wrapped, i, 0.3));
        expect_near(bezier(c.segment(i), 0.3), catmull_rom(wrapped, i, 0.3));
    }
}

TEST(Splines, CountsOfPoints) {
    EXPECT_TRUE(is_profile_count(Spline::linear, 2));
    EXPECT_FALSE(is_profile_count(Spline::linear, 1));
    EXPECT_TRUE(is_profile_count(Spline::bezier, 7));
    EXPECT_FALSE(is_profile_count(Spline::bezier, 1));
    EXPECT_FALSE(is_profile_count(Spline::bezier, 6));
    EXPECT_FALSE(is_profile_count(Spline::bspline, 3));
    EXPECT_TRUE(is_outline_count(Spline::bezier, 6));
    EXPECT_FALSE(is_outline_count(Spline::bezier, 7));
    EXPECT_FALSE(is_outline_count(Spline::catmull_rom, 2));
}

TEST(Splines, NegativeRadiusIsThatOfTheCurveNotOfItsControlPoints) {
    const auto dips = [](double inner) {
        return negative_radius(profile_curve(
            Spline::bezier, std::vector<Vec2d>{{1, 0}, {inner, 1}, {inner, 2}, {1, 3}}));
    };
    // r = 1/4 + 3/4 inner in the middle.
    EXPECT_FALSE(dips(-1.0 / 3 + 1e-6));
    const auto found = dips(-1.0 / 3 - 1e-6);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->parameter, 0.5, 1e-12);
    EXPECT_LT(found->point.x, 0);
    EXPECT_TRUE(negative_radius(
        profile_curve(Spline::linear, std::vector<Vec2d>{{1, 0}, {-1e-9, 1}, {1, 2}})));
    // The guiding points of a curve that starts on the axis may lie beyond it.
    const auto on_axis =
        profile_curve(Spline::bspline,
                      std::vector<Vec2d>{{-0.3, 0}, {0, 0}, {0.3, 0}, {0.3, 1}, {0, 1}, {-0.3, 1}});
    EXPECT_FALSE(negative_radius(on_axis));
    EXPECT_TRUE(encloses_space(on_axis));
}

TEST(Splines, NegativeRadiusAtRandomMatchesSampling) {
    std::mt19937 generator(7);
    std::uniform_real_distribution<double> place(-0.6, 1);
    int negative = 0;
    for (int round = 0; round < 500; ++round) {
        std::vector<Vec2d> points;
        for (int i = 0; i < 4; ++i) points.emplace_back(place(generator) * 1e150, i);
        const auto curve = profile_curve(Spline::bezier, points);
        double least = 0;
        for (int k = 0; k <= 1000; ++k) {
            least = std::min(least, bezier(points, k / 1000.0).x);
        }
        const auto found = negative_radius(curve);
        EXPECT_EQ(found.has_value(), least < 0) << round;
        if (found) {
            EXPECT_LE(found->point.x, least * (1 - 1e-12));
            ++negative;
        }
    }
    EXPECT_GT(negative, 100);
    EXPECT_LT(negative, 450);
}

std::vector<Vec2d> scaled(std::vector<Vec2d> points, double factor) {
    for (Vec2d& p : points) p *= factor;
    return points;
}

TEST(Splines, SelfCrossings) {
    const std::vector<Vec2d> bow{{0, 0}, {2, 2}, {2, 0}, {0, 2}};
    const std::vector<Vec2d> square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
    const std::vector<Vec2d> notch{{0, 0}, {4, 0}, {4, 4}, {2, 1e-9}, {0, 4}};
    // A ring cut open: its seam runs along itself, which is no crossing.
    const std::vector<Vec2d> keyhole{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0},
                                     {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}};
    for (const double factor : {1.0, 1e90, 1e-90}) {
        for (const Spline spline : {Spline::linear, Spline::bspline, Spline::catmull_rom}) {
            EXPECT_TRUE(self_crossing(outline_curve(spline, scaled(bow, factor))));
            EXPECT_FALSE(self_crossing(outline_curve(spline, scaled(square, factor))));
        }
        EXPECT_FALSE(self_crossing(outline_curve(Spline::linear, scaled(notch, factor))));
        EXPECT_FALSE(self_crossing(outline_curve(Spline::linear, scaled(keyhole, factor))));
    }
    const auto at = self_crossing(outline_curve(Spline::linear, bow));
    ASSERT_TRUE(at);
    expect_near(*at, {1, 1});
}

TEST(Splines, SelfCrossingsOfBezierOutlines) {
    // One segment that is a loop in itself, and one that returns without crossing.
    EXPECT_TRUE(self_crossing(outline_curve(
        Spline::bezier, std::vector<Vec2d>{{0, 0}, {3, 3}, {-2, 3}, {1, 0}, {1, -1}, {0, -1}})));
    EXPECT_FALSE(
        self_crossing(outline_curve(Spline::bezier, std::vector<Vec2d>{{0, 0}, {2, 2}, {-2, 2}})));
    // A symmetric figure of eight.
    EXPECT_TRUE(self_crossing(outline_curve(
        Spline::bezier, std::vector<Vec2d>{{-1, 1}, {1, 1}, {-1, -1}, {1, -1}, {-1, -1}, {1, 1}})));
    // A leaf: both sides leave the tip in the same direction.
    EXPECT_FALSE(self_crossing(outline_curve(
        Spline::bezier, std::vector<Vec2d>{{0, 0}, {1, 0}, {2, 1}, {3, 3}, {1, 2}, {0.5, 0}})));
}

TEST(Splines, LongOutlinesAreQuick) {
    std::vector<Vec2d> star;
    for (int i = 0; i < 20000; ++i) {
        const double angle = tau * i / 20000;
        const double r = i % 2 == 0 ? 1 : 0.9;
        star.emplace_back(r * elementary::cos(angle), r * elementary::sin(angle));
    }
    EXPECT_FALSE(self_crossing(outline_curve(Spline::linear, star)));
    EXPECT_FALSE(self_crossing(outline_curve(Spline::bspline, star)));
    std::swap(star[100], star[105]);
    EXPECT_TRUE(self_crossing(outline_curve(Spline::linear, star)));
}

}  // namespace
}  // namespace lancer
