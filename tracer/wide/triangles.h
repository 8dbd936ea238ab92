// Intersects eight rays with one triangle, or one ray with four: shapes/triangle.h and rays/shear.h
// for lanes. The proofs are there.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

LANCER_INLINE const Numbers& component(const Vectors& v, int axis) {
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}
LANCER_INLINE Vectors cross(const Vectors& a, const Vectors& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Woop's shears of eight rays. Rays with the same permutation of axes are one group. Rays that
/// stay together mostly are a single group.
struct Shears {
    struct Group {
        int x, y, z;
        Mask mask;
    };
    Numbers sx, sy, sz, noise;
    Group groups[6];
    int count = 0;

    /// \param active  not empty
    /// \param reach   bound on the coordinates of all corners
    void set(const Rays& r, double reach, Mask active) {
        const Vectors size = absolute(r.dir);
        const Mask x_over_y = less(size.y, size.x);
        const Mask along_x = x_over_y & less(size.z, size.x);
        const Mask along_y = ~x_over_y & less(size.z, size.y);
        const Numbers zero = all(0.0);
        sx = sy = sz = zero;
        for (int z = 0; z < 3; ++z) {
            const Mask along = active & (z == 0 ? along_x : z == 1 ? along_y : ~along_x & ~along_y);
            const Mask backward = along & less(component(r.dir, z), zero);
            // If the direction is negative along z, x and y are swapped, which keeps the winding.
            add(r, {(z + 1) % 3, (z + 2) % 3, z, along & ~backward});
            add(r, {(z + 2) % 3, (z + 1) % 3, z, backward});
        }
        constexpr double by_error = 1 / gamma<double, 16>;
        const Numbers places = all(reach) + r.filter_error * all(by_error);
        noise = select(r.whole, zero, bound<512>() * places * places);
    }

  private:
    LANCER_INLINE void add(const Rays& r, const Group& g) {
        if (g.mask == 0) return;
        const Numbers& inverse = component(r.inv_dir, g.z);
        sx = select(g.mask, component(r.dir, g.x) * inverse, sx);
        sy = select(g.mask, component(r.dir, g.y) * inverse, sy);
        sz = select(g.mask, inverse, sz);
        groups[count++] = g;
    }
};

/// A triangle after the shear: the coordinates of its corners across the rays.
struct Sheared {
    Numbers ax, ay, bx, by, cx, cy;

    LANCER_INLINE Sheared(const Shears& s, const Shears::Group& g, const Vectors& a,
                          const Vectors& b, const Vectors& c)
        : ax(component(a, g.x) - s.sx * component(a, g.z)),
          ay(component(a, g.y) - s.sy * component(a, g.z)),
          bx(component(b, g.x) - s.sx * component(b, g.z)),
          by(component(b, g.y) - s.sy * component(b, g.z)),
          cx(component(c, g.x) - s.sx * component(c, g.z)),
          cy(component(c, g.y) - s.sy * component(c, g.z)) {}

    /// Rays that may meet the triangle; all others miss it for certain.
    LANCER_INLINE Mask may_meet(const Numbers& noise) const {
        const Numbers u = cx * by - cy * bx;
        const Numbers v = ax * cy - ay * cx;
        const Numbers w = bx * ay - by * ax;
        return ~(less(smaller(smaller(u, v), w), -noise) & less(noise, larger(larger(u, v), w)));
    }
};

struct TriangleCorners {
    Vectors a, b, c;

    LANCER_INLINE TriangleCorners(const TriangleBlock& block, int i)
        : a{all(block.corner[0][0][i]), all(block.corner[0][1][i]), all(block.corner[0][2][i])},
          b{all(block.corner[1][0][i]), all(block.corner[1][1][i]), all(block.corner[1][2][i])},
          c{all(block.corner[2][0][i]), all(block.corner[2][1][i]), all(block.corner[2][2][i])} {}

    /// All four triangles, twice.
    LANCER_INLINE explicit TriangleCorners(const TriangleBlock& block)
        : a(corners(block.corner[0])), b(corners(block.corner[1])), c(corners(block.corner[2])) {}

    /// The filter, from plain differences: the rays of the group that may meet the triangle.
    LANCER_INLINE Mask may_meet(const Rays& r, const Shears& s, const Shears::Group& g) const {
        return Sheared(s, g, a - r.origin, b - r.origin, c - r.origin).may_meet(s.noise);
    }

  private:
    LANCER_INLINE static Vectors corners(const double (&places)[3][4]) {
        return {load_twice(places[0]), load_twice(places[1]), load_twice(places[2])};
    }
};

/// One ray, prepared for the filter against four triangles: the axes of its Shears::Group, and
/// numbers with the same value in all four lanes.
struct LoneShear {
    int x, y, z;
    Fours sx, sy;
    Fours ox, oy, oz;
    Fours noise;

    /// Bit k: whether the ray may meet triangle k of the block.
    LANCER_INLINE Mask may_meet(const TriangleBlock& block) const {
        struct Across {
            Fours x, y;
        };
        const auto across = [&](int c) {
            const Fours height = four(block.corner[c][z]) - oz;
            return Across{(four(block.corner[c][x]) - ox) - sx * height,
                          (four(block.corner[c][y]) - oy) - sy * height};
        };
        const Across a = across(0);
        const Across b = across(1);
        const Across c = across(2);
        const Fours u = c.x * b.y - c.y * b.x;
        const Fours v = a.x * c.y - a.y * c.x;
        const Fours w = b.x * a.y - b.y * a.x;
        return ~(less(smaller(smaller(u, v), w), -noise) & less(noise, larger(larger(u, v), w)));
    }
};

/// The same for ray `i`.
LANCER_INLINE Mask may_meet(const TriangleBlock& block, const Rays& r, const Shears& s,
                            const Shears::Group& g, int i) {
    const LoneShear shear{g.x,
                          g.y,
                          g.z,
                          four(lane(s.sx, i)),
                          four(lane(s.sy, i)),
                          four(lane(component(r.origin, g.x), i)),
                          four(lane(component(r.origin, g.y), i)),
                          four(lane(component(r.origin, g.z), i)),
                          four(lane(s.noise, i))};
    return shear.may_meet(block);
}

struct TriangleHits {
    Mask mask;
    Numbers t, error, u, v;
    Mask entering;
};

/// signed_difference_of_products()
LANCER_INLINE Numbers signed_difference_of_products(const Numbers& a, const Numbers& b,
                                                    const Numbers& c, const Numbers& d) {
    const Numbers ab = a * b;
    const Numbers cd = c * d;
    const Mask equals = equal(ab, cd);
    if (equals == 0) return ab - cd;
    return select(equals, product_rest(a, b, ab) - product_rest(c, d, cd), ab - cd);
}

/// triangle_error(), for triangles that no transform has moved
LANCER_INLINE Numbers triangle_error(const Rays& r, const Shears& s, const Shears::Group& g,
                                     const Vectors& a, const Vectors& b, const Vectors& c,
                                     const Numbers& det, const Numbers& t, const Vectors& products,
                                     const Vectors& z) {
    const Vectors n = absolute(cross(b - a, c - a));
    const auto larger_size = [](const Numbers& x, const Numbers& y, const Numbers& w) {
        return larger(absolute(w), larger(absolute(y), absolute(x)));
    };
    const Vectors size{larger_size(a.x, b.x, c.x), larger_size(a.y, b.y, c.y),
                       larger_size(a.z, b.z, c.z)};
    const Numbers& along = component(size, g.z);
    const Numbers two = all(2.0);
    const Numbers six = all(6.0);
    const Numbers moved =
        component(n, g.x) * (two * component(size, g.x) + six * absolute(s.sx) * along) +
        component(n, g.y) * (two * component(size, g.y) + six * absolute(s.sy) * along) +
        component(n, g.z) * along;
    const Numbers by_start = r.origin_error * (n.x + n.y + n.z);
    const Numbers weights = products.x * (absolute(z.x - t) + absolute(z.x)) +
                            products.y * (absolute(z.y - t) + absolute(z.y)) +
                            products.z * (absolute(z.z - t) + absolute(z.z));
    return ((all(unit_roundoff<double>) * moved + by_start) * absolute(s.sz) +
            bound<4>() * weights) /
               absolute(det) +
           bound<3>() * absolute(t);
}

/// intersect_exactly(), for the rays of the mask, which belong to the group. Crossings beyond
/// `last` are left out.
LANCER_INLINE TriangleHits intersect_exactly(const TriangleCorners& triangle, const Rays& r,
                                             const Shears& s, const Shears::Group& g, Mask mask,
                                             const Numbers& last) {
    const Vectors a = -start_from(r, triangle.a);
    const Vectors b = -start_from(r, triangle.b);
    const Vectors c = -start_from(r, triangle.c);
    const Sheared p(s, g, a, b, c);
    TriangleHits hits;
    const Numbers u = signed_difference_of_products(p.cx, p.by, p.cy, p.bx);
    const Numbers v = signed_difference_of_products(p.ax, p.cy, p.ay, p.cx);
    const Numbers w = signed_difference_of_products(p.bx, p.ay, p.by, p.ax);
    const Numbers zero = all(0.0);
    const Mask some_negative = less(u, zero) | less(v, zero) | less(w, zero);
    const Mask some_positive = less(zero, u) | less(zero, v) | less(zero, w);
    const Numbers det = u + v + w;
    hits.mask = mask & ~(some_negative & some_positive) & ~equal(det, zero);
    if (hits.mask == 0) return hits;
    const Vectors z{s.sz * component(a, g.z), s.sz * component(b, g.z), s.sz * component(c, g.z)};
    hits.t = (u * z.x + v * z.y + w * z.z) / det;
    hits.mask &= ~less(last, hits.t);
    if (hits.mask == 0) return hits;
    const Vectors products{absolute(p.cx * p.by) + absolute(p.cy * p.bx),
                           absolute(p.ax * p.cy) + absolute(p.ay * p.cx),
                           absolute(p.bx * p.ay) + absolute(p.by * p.ax)};
    hits.error = triangle_error(r, s, g, a, b, c, det, hits.t, products, z);
    hits.u = v / det;
    hits.v = w / det;
    hits.entering = less(zero, det);
    return hits;
}

}  // namespace lancer::wide::LANCER_LEVEL
