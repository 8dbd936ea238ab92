// Cases of one shape, each from its own random number generator, and the errors of the kernel: so
// the number of a bad case identifies it, and worst_cases.h can store it.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <random>
#include <string>
#include <vector>

#include "tests/oracle/exact.h"
#include "tests/oracle/worst_cases.h"
#include "tracer/rays/crossing.h"
#include "tracer/rays/ray.h"
#include "tracer/rays/surface_point.h"

namespace lancer::oracle {

/// The random numbers of one case.
class Draw {
  public:
    explicit Draw(std::uint64_t number) : number_(number), random_(number) {}

    std::uint64_t number() const { return number_; }
    double unit() { return static_cast<double>(random_() >> 11) / 9007199254740992.0; }
    double between(double a, double b) { return a + (b - a) * unit(); }
    double decade(double low, double high) { return std::pow(10.0, between(low, high)); }
    Vec3d direction() {
        for (;;) {
            const Vec3d v(between(-1, 1), between(-1, 1), between(-1, 1));
            const double l = length_squared(v);
            if (l > 0.01 && l < 1) return normalize(v);
        }
    }
    /// From some distance (10^-3 to 10^4 sizes) towards a place near the shape; some rays along an
    /// axis, some with nearly one.
    Ray<double> ray_at(const Vec3d& place, double size) {
        const Vec3d target = place + direction() * (size * between(0, 1));
        const Vec3d from = place + direction() * (size * decade(-3, 4));
        Vec3d dir = normalize(target - from);
        if (number_ % 16 == 3) {
            const int axis = static_cast<int>(number_ / 16 % 3);
            Vec3d along(0.0);
            along[axis] = dir[axis] < 0 ? -1 : 1;
            dir = normalize(along + (number_ % 32 < 16 ? 0.0 : decade(-300, -1)) * dir);
            return make_ray(target - dir * (size * decade(-3, 4)), Vec3d(0), dir, 0.0);
        }
        return make_ray(from, Vec3d(0), dir, 0.0);
    }

    /// The same ray; in a third of the cases, its start consists of two numbers. Later random
    /// numbers do not depend on this.
    Ray<double> in_two_parts(const Ray<double>& ray) const {
        if (number_ % 3 != 1) return ray;
        Draw other(~number_);
        Vec3d low(0.0);
        for (int i = 0; i < 3; ++i)
            low[i] = ray.origin[i] * other.between(-1, 1) * unit_roundoff<double>;
        return make_ray(ray.origin, low, ray.dir, 0.0);
    }

  private:
    std::uint64_t number_;
    std::mt19937_64 random_;
};

inline ExactVec start_of(const Ray<double>& ray) {
    return exact(ray.origin) + exact(ray.origin_lo);
}

class Tally {
  public:
    explicit Tally(std::string shape) : shape_(std::move(shape)) {}

    /// Runs LANCER_ORACLE_RAYS cases, or ten thousand, and the worst earlier cases.
    template <class Case>
    void run(Case&& one_case) {
        const char* wanted = std::getenv("LANCER_ORACLE_RAYS");
        const std::uint64_t count = wanted == nullptr ? 10000 : std::strtoull(wanted, nullptr, 10);
        const auto run_one = [&](std::uint64_t number) {
            number_ = number;
            Draw draw(number);
            one_case(draw);
        };
        for (std::uint64_t i = 0; i < count; ++i) run_one(i);
        for (const WorstCase& worst : worst_cases) {
            if (worst.shape == shape_) run_one(worst.number);
        }
    }

    /// For a tally whose cases another one runs.
    void at(const Draw& draw) { number_ = draw.number(); }

    /// A crossing whose true parameter is t, on a shape of this size.
    void hit(const Ray<double>& ray, const Crossing<double>& c, const Exact& t, double size) {
        ++hits_;
        const double speed = std::sqrt(ray.dir_squared);
        const double scale = std::max(std::abs(c.t), size / speed) * epsilon;
        const double error = static_cast<double>(abs(Exact(c.t) - t));
        note(t_, error / scale);
        slack_.push_back(c.error / scale);
        note(used_, error == 0 ? 0 : error / c.error);
    }
    /// A point with the distance `off` from the surface, and its normal compared with the true one.
    void point(const SurfacePoint<double>& p, const Exact& off, const ExactVec& normal,
               double size) {
        const double distance = static_cast<double>(abs(off));
        note(point_, distance / size / epsilon);
        note(point_used_, distance == 0 ? 0 : distance / p.error);
        note(normal_,
             static_cast<double>(length(unit_of(exact(p.normal)) - unit_of(normal))) / epsilon);
    }
    /// Whether a crossing that certainly exists was found.
    void expect_found(bool found) {
        EXPECT_TRUE(found) << shape_ << ", case " << number_ << ": a crossing was missed";
    }

    /// One row of the table in docs/accuracy.md, and the requirements.
    void report(double most_typical = 200) {
        ASSERT_GT(hits_, 100u);
        std::nth_element(slack_.begin(), slack_.begin() + static_cast<std::ptrdiff_t>(hits_ / 2),
                         slack_.end());
        const double typical = slack_[hits_ / 2];
        std::cout << "| " << shape_ << " | " << hits_;
        for (const double x : {t_.most, typical, used_.most}) print(x);
        for (const Worst& x : {point_, point_used_, normal_}) {
            if (x.asked)
                print(x.most);
            else
                std::cout << " | ";
        }
        std::cout << " | " << used_.number << " |\n";
        EXPECT_LE(used_.most, 1) << shape_ << ": t is off by more than its bound, case "
                                 << used_.number;
        EXPECT_LE(point_used_.most, 1)
            << shape_ << ": a point is off by more than its bound, case " << point_used_.number;
        EXPECT_LE(typical, most_typical)
            << shape_ << ": half of the bounds are wider than this, in ulps";
    }

  private:
    static constexpr double epsilon = std::numeric_limits<double>::epsilon();

    struct Worst {
        double most = 0;
        std::uint64_t number = 0;
        bool asked = false;
    };
    void note(Worst& worst, double value) const {
        worst.asked = true;
        if (value <= worst.most) return;
        worst.most = value;
        worst.number = number_;
    }
    static void print(double x) {
        std::cout.precision(2);
        std::cout << " | " << x;
    }

    std::string shape_;
    std::uint64_t number_ = 0;
    std::uint64_t hits_ = 0;
    Worst t_;                    ///< ulps of the larger of |t| and the shape's size
    Worst used_;                 ///< share of the bound: above 1 the bound is wrong
    std::vector<double> slack_;  ///< the bound in ulps of the same
    Worst point_;                ///< distance from the surface, ulps of the size
    Worst point_used_;
    Worst normal_;  ///< ulps of 1
};

}  // namespace lancer::oracle
