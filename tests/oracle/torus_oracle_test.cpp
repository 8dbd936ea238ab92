// Tori compared with 256-bit arithmetic: tubes from a billionth of the ring's radius up to those
// that close the hole, from near and far, with rays straight at them and nearly past them.
#include "model/shapes.h"
#include "tests/oracle/tally.h"
#include "tracer/numerics/power_of_two.h"
#include "tracer/shapes/torus.h"

namespace lancer::oracle {
namespace {

using lancer::cross;
using lancer::dot;
using lancer::length;

struct Ring {
    double radius, tube;

    double size() const { return radius + tube; }
    TorusSolid<double> solid() const {
        const int to_one = exponent_for(radius);
        return {std::ldexp(radius, to_one), std::ldexp(tube, to_one), std::ldexp(1.0, to_one),
                std::ldexp(1.0, -to_one)};
    }
};

/// The textbook's quartic along a line; it is positive outside.
struct ExactRing {
    const Ring& ring;
    ExactVec start, dir;
    Exact dd = dot(dir, dir);
    Exact along = dot(start, dir);
    Exact square = dot(start, start);

    Exact value(const Exact& t) const {
        const Exact k = at(t);
        const Exact x = start.x + t * dir.x;
        const Exact z = start.z + t * dir.z;
        return k * k - 4 * Exact(ring.radius) * ring.radius * (x * x + z * z);
    }
    Exact slope(const Exact& t) const {
        const Exact across = (start.x + t * dir.x) * dir.x + (start.z + t * dir.z) * dir.z;
        return 4 * at(t) * (dd * t + along) - 8 * Exact(ring.radius) * ring.radius * across;
    }

    /// The root between two places of different sign.
    template <class F>
    static Exact between(Exact low, Exact high, const F& f) {
        const bool rising = f(low) < 0;
        for (int i = 0; i < 64; ++i) {
            const Exact middle = (low + high) / 2;
            ((f(middle) < 0) == rising ? low : high) = middle;
        }
        return (low + high) / 2;
    }

    /// The true crossing for `c`; none where the line only touches the surface.
    bool find(const Crossing<double>& c, Exact& t) const {
        const Exact low = Exact(c.t) - c.error;
        const Exact high = Exact(c.t) + c.error;
        const auto f = [this](const Exact& at_t) { return value(at_t); };
        if ((value(low) < 0) != (value(high) < 0)) {
            t = between(low, high, f);
            return true;
        }
        const auto df = [this](const Exact& at_t) { return slope(at_t); };
        if ((slope(low) < 0) == (slope(high) < 0)) return false;
        const Exact top = between(low, high, df);
        if ((value(top) < 0) == (value(low) < 0)) return false;
        const bool first = (value(low) < 0) != c.entering;
        t = first ? between(low, top, f) : between(top, high, f);
        return true;
    }

  private:
    Exact at(const Exact& t) const {
        return dd * t * t + 2 * along * t + square + Exact(ring.radius) * ring.radius -
               Exact(ring.tube) * ring.tube;
    }
};

Ring random_ring(Draw& draw) {
    const double radius = draw.decade(-2, 2);
    return {radius, draw.number() % 7 == 0 ? radius : radius * draw.decade(-9, 0)};
}

/// A place on the ring's surface, and the normal there.
void on_surface(Draw& draw, const Ring& ring, Vec3d& anchor, Vec3d& outward) {
    const double angle = draw.between(0, 6.28318);
    const double round = draw.between(0, 6.28318);
    const Vec3d away(std::cos(angle), 0, std::sin(angle));
    anchor = away * ring.radius;
    outward = away * std::cos(round) + Vec3d(0, std::sin(round), 0);
}

Ray<double> random_ray(Draw& draw, const Ring& ring) {
    Vec3d anchor;
    Vec3d outward;
    on_surface(draw, ring, anchor, outward);
    const Vec3d target = anchor + outward * (ring.tube * draw.unit());
    const Vec3d from = target + draw.direction() * (ring.size() * draw.decade(-3, 4));
    Vec3d dir = normalize(target - from);
    if (draw.number() % 2 == 0) return make_ray(from, Vec3d(0), dir, 0.0);
    dir = normalize(cross(outward, draw.direction()));  // nearly tangent
    const Vec3d edge = anchor + outward * (ring.tube * (1 - draw.decade(-17, -1)));
    return make_ray(edge - dir * (ring.size() * draw.decade(-3, 4)), Vec3d(0), dir, 0.0);
}

void judge_point(Tally& tally, const Ring& ring, const ExactRing& exactly, const Ray<double>& ray,
                 const Crossing<double>& c) {
    const SurfacePoint<double> p = surface_point(ring.solid(), ray, c.t, 0);
    const auto from_ring = [&](const ExactVec& at) {
        const Exact share = Exact(ring.radius) / sqrt(at.x * at.x + at.z * at.z);
        return at - ExactVec{at.x * share, 0, at.z * share};
    };
    const ExactVec off = from_ring(exact(p.anchor) + exact(p.offset));
    const ExactVec normal = from_ring(exactly.start + Exact(c.t) * exactly.dir);
    tally.point(p, length(off) - ring.tube, normal, ring.size());
}

TEST(Oracle, Torus) {
    Tally tally("torus");
    int touching = 0;
    int hits = 0;
    tally.run([&](Draw& draw) {
        const Ring ring = random_ring(draw);
        const Ray<double> ray = draw.in_two_parts(random_ray(draw, ring));
        const ExactRing exactly{ring, start_of(ray), exact(ray.dir)};
        std::vector<Crossing<double>> found;
        crossings(ring.solid(), ray, IntersectionHints{}, whole_line<double>(),
                  [&](const Crossing<double>& c) { found.push_back(c); });
        EXPECT_EQ(found.size() % 2, 0u) << "case " << draw.number();
        for (std::size_t i = 0; i < found.size(); ++i) {
            const Crossing<double>& c = found[i];
            EXPECT_EQ(c.entering, i % 2 == 0) << "case " << draw.number();
            ++hits;
            Exact t;
            if (exactly.find(c, t))
                tally.hit(ray, c, t, ring.size());
            else
                ++touching;
            judge_point(tally, ring, exactly, ray, c);
        }
        // Between the crossings, the sign of the quartic tells whether the line is inside.
        const double middle = -static_cast<double>(exactly.along / exactly.dd);
        for (int i = 0; i <= 24; ++i) {
            const double at = middle + ring.size() * (i / 12.0 - 1) * 1.01;
            bool inside = false;
            bool unsure = false;
            for (const Crossing<double>& c : found) {
                inside = c.t < at ? c.entering : inside;
                unsure = unsure || std::abs(c.t - at) <= c.error;
            }
            const Exact f = exactly.value(at);
            const double scale = ring.radius * ring.tube;
            const double far = std::max(1.0, std::abs(middle) / ring.size());
            const double noise = 1e-12 * scale * ring.size() * ring.size() * far;
            if (!unsure && abs(f) > noise) tally.expect_found(inside == (f < 0));
        }
    });
    EXPECT_LT(touching, hits / 20);
    tally.report();
}

/// The other crossings from a start on the surface: the start itself is left out at any angle.
TEST(Oracle, TorusFromItsSurface) {
    Tally tally("torus, from its surface");
    tally.run([&](Draw& draw) {
        const Ring ring = random_ring(draw);
        Vec3d anchor;
        Vec3d outward;
        on_surface(draw, ring, anchor, outward);
        const DoubleWordVector<double> start = two_sum(anchor, outward * ring.tube);
        Vec3d dir = draw.direction();
        if (draw.number() % 5 < 2)
            dir = normalize(normalize(cross(outward, dir)) + outward * draw.decade(-16, -1));
        const double error = gamma<double>(8) * ring.size();
        const Ray<double> ray = make_ray(start.hi, start.lo, dir, error);
        const ExactRing exactly{ring, start_of(ray), exact(ray.dir)};
        const double steep = dot(outward, dir);
        // The distance over which the line's way out is clear of rounding. Where the hole nearly
        // closes, the opposite surface is as near.
        const Vec3d at = anchor + outward * ring.tube;
        const double across = std::hypot(at.x, at.z) + ring.radius;
        const double alone = (across * across + at.y * at.y - ring.tube * ring.tube) /
                             (4 * ring.radius * ring.radius);
        const bool clear = std::abs(steep) * alone * ring.tube > 1e-6 * ring.size();
        const bool inside = steep < 0;
        bool state = inside;
        crossings(ring.solid(), ray, IntersectionHints{0, inside}, whole_line<double>(),
                  [&](const Crossing<double>& c) {
                      Exact t;
                      if (exactly.find(c, t)) tally.hit(ray, c, t, ring.size());
                      if (c.t < 0 || !clear) return;
                      EXPECT_NE(c.entering, state) << "case " << draw.number();
                      EXPECT_GT(c.t, c.error) << "case " << draw.number();
                      state = c.entering;
                  });
        if (clear) {
            EXPECT_FALSE(state) << "case " << draw.number() << ": it stays inside for ever";
        }
    });
    tally.report(1000);
}

}  // namespace
}  // namespace lancer::oracle
