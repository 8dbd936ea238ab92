// Cuts a bicubic patch into pieces that are nearly flat and evenly parametrised, so that Newton's
// method converges quickly on each: Martin, Cohen, Fish, Shirley, "Practical ray tracing of trimmed
// NURBS surfaces", JGT 5(1) 2000, section 3.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "tracer/splines/bicubic.h"
#include "tracer/splines/plane_zeros.h"

namespace lancer::splines {

/// A part of a Bezier patch: its own 16 control points, by coordinate, and its parameters.
template <class Real>
struct Piece {
    std::array<std::array<Real, 16>, 3> c;  ///< relative to an anchor, the same for the whole patch
    Real u0, v0, du, dv;                    ///< its rectangle in the patch's parameter square
};

template <class Real>
Vec3<Real> control_point(const Piece<Real>& piece, std::size_t i) {
    return {piece.c[0][i], piece.c[1][i], piece.c[2][i]};
}

/// The rows of the inverse of (u, v, n / |n|), for the piece's mean directions u and v and their
/// normal n. The last row is in units of the shorter direction. Nothing if there is no mean plane.
template <class Real>
std::optional<std::array<Vec3<Real>, 3>> mean_frame(const Piece<Real>& piece) {
    using std::sqrt;
    const auto at = [&](std::size_t i) { return control_point(piece, i); };
    const Vec3<Real> u = ((at(3) - at(0)) + (at(15) - at(12))) / Real(2);
    const Vec3<Real> v = ((at(12) - at(0)) + (at(15) - at(3))) / Real(2);
    const Vec3<Real> n = cross(u, v);
    const Real nn = length_squared(n);
    if (!(nn > 0)) return {};
    return std::array{cross(v, n) / nn, cross(n, u) / nn,
                      n / sqrt(nn * std::min(length_squared(u), length_squared(v)))};
}

/// Whether the piece is nearly flat and even: its slopes differ from their means by at most `most`
/// times the means, measured along the piece's two mean directions and across them.
template <class Real>
bool is_even(const Piece<Real>& piece, Real most) {
    using std::abs;
    const auto frame = mean_frame(piece);
    if (!frame) return false;
    const auto at = [&](std::size_t i) { return control_point(piece, i); };
    const auto off = [&](const Vec3<Real>& slope, Real along_u, Real along_v) {
        return std::max({abs(dot((*frame)[0], slope) - along_u),
                         abs(dot((*frame)[1], slope) - along_v), abs(dot((*frame)[2], slope))});
    };
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            const std::size_t along = 4 * i + j;
            const std::size_t across = 4 * j + i;
            if (off(Real(3) * (at(along + 1) - at(along)), 1, 0) > most) return false;
            if (off(Real(3) * (at(across + 4) - at(across)), 0, 1) > most) return false;
        }
    }
    return true;
}

/// Halves a piece until its parts are even, but at most `levels` times.
template <class Real>
void cut(const Piece<Real>& piece, Real most, int levels, std::vector<Piece<Real>>& pieces) {
    using std::sqrt;
    if (levels == 0 || is_even(piece, most)) {
        pieces.push_back(piece);
        return;
    }
    // Halve across the longer direction.
    Real longest[2] = {0, 0};
    for (std::size_t k = 0; k < 2; ++k) {
        const std::size_t step = k == 0 ? 1 : 4;
        for (std::size_t i = 0; i < 4; ++i) {
            Real length = 0;
            for (std::size_t j = 0; j < 3; ++j) {
                const std::size_t p = k == 0 ? 4 * i + j : 4 * j + i;
                Real squared = 0;
                for (const auto& c : piece.c)
                    squared += (c[p + step] - c[p]) * (c[p + step] - c[p]);
                length += sqrt(squared);
            }
            longest[k] = std::max(longest[k], length);
        }
    }
    const bool by_u = longest[0] >= longest[1];
    Piece<Real> low = piece;
    Piece<Real> high = piece;
    for (std::size_t k = 0; k < 3; ++k) halve(piece.c[k], by_u, low.c[k], high.c[k]);
    if (by_u) {
        low.du = high.du = piece.du / 2;
        high.u0 += high.du;
    } else {
        low.dv = high.dv = piece.dv / 2;
        high.v0 += high.dv;
    }
    cut(low, most, levels - 1, pieces);
    cut(high, most, levels - 1, pieces);
}

}  // namespace lancer::splines
