// The estimates by which filters skip exact crossings: every estimate must contain the exact
// crossing, extended by eight of its error bounds on either side (RayInterval::accepts_estimate),
// and no crossing within the interval may be missing.
#include "tests/oracle/tally.h"
#include "tracer/rays/crossing.h"
#include "tracer/shapes/frustum.h"
#include "tracer/shapes/plane.h"
#include "tracer/shapes/sphere.h"

namespace lancer::oracle {
namespace {

using lancer::cross;

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Guess {
    double low, high;

    bool holds(const Crossing<double>& c) const {
        return c.t - 8 * c.error >= low && c.t + 8 * c.error <= high;
    }
};

/// A query that receives estimates and never accepts one.
struct Notes {
    std::vector<Guess>& guesses;

    double operator()() const { return infinity; }
    bool accepts_estimate(double low, double high) const {
        guesses.push_back({low, high});
        return false;
    }
};

/// Guesses of one shape's crossings, in many cases.
class Guesses {
  public:
    template <class Shape>
    void check(const Shape& shape, const Ray<double>& ray, Draw& draw) {
        std::vector<Guess> guesses;
        const Notes notes{guesses};
        std::vector<Crossing<double>> found;
        crossings(shape, ray, IntersectionHints{}, RayInterval<double, Notes>{-infinity, notes},
                  [&](const Crossing<double>& c) { found.push_back(c); });
        crossings_ += found.size();
        for (const Guess& guess : guesses) check(guess, found, draw);
        for (const Crossing<double>& c : found) {
            const double shift = draw.decade(-16, 0) * std::abs(c.t);
            const auto end = [&] { return c.t + shift; };
            const RayInterval<double, decltype(end)> near{c.t - shift, end};
            // A query for all crossings, and one only for those that enter or leave.
            for (const IntersectionHints& hints :
                 {IntersectionHints{}, IntersectionHints{none, !c.entering, true}}) {
                bool met = false;
                const auto meets = [&](const Crossing<double>& other) { met |= other.t == c.t; };
                crossings(shape, ray, hints, near, meets);
                EXPECT_TRUE(met) << "case " << draw.number() << ": a crossing was left out";
            }
        }
    }
    void check(const Guess& guess, const std::vector<Crossing<double>>& found, const Draw& draw) {
        ++guesses_;
        const bool held =
            std::any_of(found.begin(), found.end(), [&](const auto& c) { return guess.holds(c); });
        EXPECT_TRUE(held) << "case " << draw.number() << ": a guess holds no crossing";
    }
    /// Filters that decide nothing would pass, but be useless.
    void expect_share(double least) const {
        EXPECT_GE(static_cast<double>(guesses_), least * static_cast<double>(crossings_));
    }

  private:
    std::size_t guesses_ = 0;
    std::size_t crossings_ = 0;
};

/// In a fifth of the cases: the error of a rounded start or solid, up to a millionth.
double moved(Draw& draw, double size) {
    const double error = size * draw.decade(-18, -6);
    return draw.number() % 5 == 2 ? error : 0;
}
Ray<double> with_error(const Ray<double>& ray, double error) {
    return make_ray(ray.origin, ray.origin_lo, ray.dir, error);
}

TEST(OracleGuesses, Sphere) {
    Guesses guesses;
    Tally("sphere, guesses").run([&](Draw& draw) {
        const Vec3d center = draw.direction() * draw.decade(-2, 2);
        const double radius = draw.decade(-3, 3);
        const BallSolid<double> ball{center, radius, moved(draw, radius)};
        Ray<double> ray = draw.ray_at(center, radius);
        if (draw.number() % 2 == 1) {  // nearly touches
            const Vec3d edge = normalize(cross(ray.dir, draw.direction()));
            const double reach = radius * (1 - draw.decade(-17, -1));
            ray = make_ray(center + edge * reach - ray.dir * (radius * draw.decade(0, 4)), Vec3d(0),
                           ray.dir, 0.0);
        }
        guesses.check(ball, with_error(draw.in_two_parts(ray), moved(draw, radius)), draw);
    });
    guesses.expect_share(0.5);
}

TEST(OracleGuesses, CylinderAndCone) {
    Guesses guesses;
    Tally("cylinder and cone, guesses").run([&](Draw& draw) {
        FrustumSolid<double> f;
        f.small_end = draw.direction() * draw.decade(-2, 2);
        f.tilted = draw.number() % 3 != 0;
        f.axis = f.tilted ? draw.direction() : Vec3d(0, 1, 0);
        f.height = draw.decade(-2, 2);
        f.large_end = f.small_end + f.height * f.axis;
        f.radius = draw.number() % 4 == 0 ? 0 : draw.decade(-3, 1);
        f.slope = draw.number() % 2 == 0 ? draw.decade(-3, 2) : (f.radius > 0 ? 0 : 0.5);
        f.capped = draw.number() % 7 != 0;
        f.transform_error = moved(draw, f.height);
        f.filter_error = f.transform_error + filter_error_of(f.small_end);
        const double size = std::max(f.height, f.radius + f.slope * f.height);
        Ray<double> ray = draw.ray_at(f.small_end + (f.height / 2) * f.axis, size);
        if (draw.number() % 6 >= 4) {  // nearly touches the side, or runs nearly along it
            const Vec3d out = normalize(cross(f.axis, draw.direction()));
            const double axial = f.height * draw.unit();
            const double reach = (f.radius + f.slope * axial) * (1 - draw.decade(-17, -1));
            const Vec3d place = f.small_end + axial * f.axis + reach * out;
            const Vec3d along =
                draw.number() % 6 == 4
                    ? normalize(cross(out - f.slope * f.axis, draw.direction()))
                    : normalize(f.axis + f.slope * out + draw.direction() * draw.decade(-16, 1));
            ray = make_ray(place - along * (size * draw.decade(-2, 4)), Vec3d(0), along, 0.0);
        }
        guesses.check(f, with_error(draw.in_two_parts(ray), moved(draw, size)), draw);
    });
    guesses.expect_share(0.2);
}

TEST(OracleGuesses, Plane) {
    Guesses guesses;
    Tally("plane, guesses").run([&](Draw& draw) {
        const HalfSpace<double> half{draw.number() % 3 == 0 ? Vec3d(0, 1, 0) : draw.direction(),
                                     draw.direction() * draw.decade(-2, 2), moved(draw, 1)};
        Ray<double> ray = draw.ray_at(half.point, 1);
        if (draw.number() % 2 == 1) {  // grazing
            const Vec3d along = normalize(cross(half.normal, draw.direction()));
            ray = make_ray(ray.origin, Vec3d(0),
                           normalize(along + half.normal * draw.decade(-20, -1)), 0.0);
        }
        ray = with_error(draw.in_two_parts(ray), moved(draw, 1));
        std::vector<Crossing<double>> found;
        crossings(half, ray, IntersectionHints{}, whole_line<double>(),
                  [&](const Crossing<double>& c) { found.push_back(c); });
        const PlaneGuess<double> guess(half, ray);
        if (!found.empty()) guesses.check(Guess{guess.low, guess.high}, found, draw);
        guesses.check(half, ray, draw);
    });
}

}  // namespace
}  // namespace lancer::oracle
