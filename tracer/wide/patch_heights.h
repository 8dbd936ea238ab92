// How the control points of a patch or a piece lie to the plane that touches the surface where a
// ray starts.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// PieceStart<double>
struct PieceStarts {
    Vectors at;
    Numbers noise;

    LANCER_INLINE PieceStarts(const PatchHome& home, const Rays& r)
        : at(start_from(r, all(home.anchor))),
          noise(all(gamma<double, 32> * home.size) + bound<8>() * max_component(absolute(at)) +
                all(2.0) * r.origin_error) {}
};

/// Control points above the plane through the ray's start that touches what it starts on.
struct Heights {
    Numbers above[16];
    Numbers unsure;  ///< what rounding makes of them

    /// \param point  point(i): control point i, relative to the anchor
    template <class Point>
    LANCER_INLINE Heights(const PatchRays& local, const PieceStarts& start, const Point& point) {
        const Vectors size = absolute(local.normal);
        unsure = start.noise * (size.x + size.y + size.z);
        const Numbers own = dot(local.normal, start.at);
        for (int i = 0; i < 16; ++i) above[i] = dot(local.normal, point(i)) - own;
    }

    /// Where the ray starts on these points' surface: it bends away from the plane to all
    /// sides, as its second derivatives tell by their coefficients, so that its height is
    /// nowhere more than rounding. Going up, a ray is above that after a stretch that is
    /// shorter than the bound of any crossing there: the rounding of the start over the same
    /// slope is part of that. What is found on this stretch is left out as the start itself is.
    LANCER_INLINE Mask bends_away() const {
        const auto bend = [&](int a, int b, int c) {
            return (above[a] + above[c]) - all(2.0) * above[b];
        };
        Numbers uu = bend(0, 1, 2);
        Numbers vv = bend(0, 4, 8);
        Numbers uv = all(0.0);
        for (int i = 0; i < 4; ++i) {
            for (int j = 0; j < 2; ++j) {
                uu = larger(bend(4 * i + j, 4 * i + j + 1, 4 * i + j + 2), uu);
                vv = larger(bend(4 * j + i, 4 * j + 4 + i, 4 * j + 8 + i), vv);
            }
        }
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
                const int k = 4 * i + j;
                const Numbers twist = (above[k] + above[k + 5]) - (above[k + 1] + above[k + 4]);
                uv = larger(absolute(twist), uv);
            }
        }
        const Numbers room = unsure * all(0.125);
        const Numbers a = room - all(6.0) * uu;
        const Numbers b = room - all(6.0) * vv;
        const Numbers c = room + all(9.0) * uv;
        const Numbers zero = all(0.0);
        return at_most(zero, a) & at_most(zero, b) & at_most(c * c, a * b);
    }
};

}  // namespace lancer::wide::LANCER_LEVEL
