// Tests whether a closed curve crosses itself, by subdivision: pieces with disjoint hulls do not
// cross, and nearly straight pieces cross when their chords do.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "model/splines.h"

namespace lancer {
namespace {

/// How often a piece may be halved before an undecided pair counts as touching.
constexpr int depth_limit = 40;
/// The number of pairs that are halved before the rest counts as touching: parts that run along
/// each other would never end.
constexpr int split_limit = 1'000'000;

/// A piece of the curve. For a straight one, the inner points are at its ends.
struct Piece {
    std::array<Vec2d, 4> p;
    bool straight = false;
};

struct Extent {
    Vec2d min, max;
};

Extent bounds(const Piece& piece) {
    Extent box{piece.p[0], piece.p[0]};
    for (const Vec2d& q : piece.p) {
        box.min = {std::min(box.min.x, q.x), std::min(box.min.y, q.y)};
        box.max = {std::max(box.max.x, q.x), std::max(box.max.y, q.y)};
    }
    return box;
}

bool overlap(const Extent& a, const Extent& b) {
    return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y;
}

long double cross(const Vec2d& a, const Vec2d& b) {
    return static_cast<long double>(a.x) * b.y - static_cast<long double>(a.y) * b.x;
}

double dot(const Vec2d& a, const Vec2d& b) {
    return a.x * b.x + a.y * b.y;
}

/// Splits into two parts of about the same length. It does not split exactly in the middle: the
/// crossing of a symmetric figure would then lie on the cut every time, and inside no part.
std::array<Piece, 2> halves(const Piece& piece) {
    constexpr double cut = 0.4853;
    const auto mid = [](const Vec2d& a, const Vec2d& b) { return a * (1.0 - cut) + b * cut; };
    const auto& p = piece.p;
    const Vec2d a = mid(p[0], p[1]);
    const Vec2d b = mid(p[1], p[2]);
    const Vec2d c = mid(p[2], p[3]);
    const Vec2d ab = mid(a, b);
    const Vec2d bc = mid(b, c);
    const Vec2d m = mid(ab, bc);
    return {Piece{{p[0], a, ab, m}, piece.straight}, Piece{{m, bc, c, p[3]}, piece.straight}};
}

/// Whether all edges of the control polygon have directions within 90 degrees; then the piece
/// cannot cross itself.
bool turns_little(const Piece& piece) {
    if (piece.straight) return true;
    const std::array e{piece.p[1] - piece.p[0], piece.p[2] - piece.p[1], piece.p[3] - piece.p[2]};
    return dot(e[0], e[1]) >= 0 && dot(e[1], e[2]) >= 0 && dot(e[0], e[2]) >= 0;
}

/// Whether the control points are so close to the chord that it can replace the curve.
bool is_flat(const Piece& piece) {
    if (piece.straight) return true;
    const Vec2d chord = piece.p[3] - piece.p[0];
    const double reach = dot(chord, chord) / 1024;
    return std::abs(static_cast<double>(cross(piece.p[1] - piece.p[0], chord))) <= reach &&
           std::abs(static_cast<double>(cross(piece.p[2] - piece.p[0], chord))) <= reach &&
           turns_little(piece);
}

/// The point where the two chords cross, if it is inside of both.
std::optional<Vec2d> chords_cross(const Piece& a, const Piece& b) {
    const Vec2d ca = a.p[3] - a.p[0];
    const Vec2d cb = b.p[3] - b.p[0];
    const long double b0 = cross(ca, b.p[0] - a.p[0]);
    const long double b1 = cross(ca, b.p[3] - a.p[0]);
    const long double a0 = cross(cb, a.p[0] - b.p[0]);
    const long double a1 = cross(cb, a.p[3] - b.p[0]);
    const bool apart_b = (b0 < 0 && b1 > 0) || (b0 > 0 && b1 < 0);
    const bool apart_a = (a0 < 0 && a1 > 0) || (a0 > 0 && a1 < 0);
    if (!apart_a || !apart_b) return std::nullopt;
    return b.p[0] + cb * static_cast<double>(b0 / (b0 - b1));
}

class Search {
  public:
    /// A crossing of two pieces that share no joint or, if `joined`, of which a ends where b
    /// begins.
    std::optional<Vec2d> pair(const Piece& a, const Piece& b, bool joined, int depth) {
        if (!overlap(bounds(a), bounds(b))) return std::nullopt;
        if (joined && (same_way(a, b) || fan_apart(a, b))) return std::nullopt;
        if (a.straight && b.straight && joined) return std::nullopt;
        if (is_flat(a) && is_flat(b) && !joined) {
            if (auto found = chords_cross(a, b)) return found;
            if (a.straight && b.straight) return std::nullopt;
        }
        if (++splits_ > split_limit || depth > depth_limit) return std::nullopt;
        const auto [a0, a1] = halves(a);
        const auto [b0, b1] = halves(b);
        if (auto found = pair(a1, b0, joined, depth + 1)) return found;
        if (auto found = pair(a0, b0, false, depth + 1)) return found;
        if (auto found = pair(a1, b1, false, depth + 1)) return found;
        return pair(a0, b1, false, depth + 1);
    }

    /// A crossing of a piece with itself.
    std::optional<Vec2d> loop(const Piece& piece, int depth) {
        if (depth > depth_limit || turns_little(piece)) return std::nullopt;
        const auto [a, b] = halves(piece);
        if (auto found = loop(a, depth + 1)) return found;
        if (auto found = loop(b, depth + 1)) return found;
        return pair(a, b, true, depth + 1);
    }

  private:
    /// Whether both pieces advance along one direction: then they meet only in their joint.
    static bool same_way(const Piece& a, const Piece& b) {
        const Vec2d way = b.p[3] - a.p[0];
        for (const Piece* piece : {&a, &b}) {
            for (std::size_t i = 0; i < 3; ++i) {
                if (dot(way, piece->p[i + 1] - piece->p[i]) < 0) return false;
            }
        }
        return dot(way, way) > 0;
    }

    /// Whether all of a is on one side of all of b, as seen from the joint.
    static bool fan_apart(const Piece& a, const Piece& b) {
        int side = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 1; j < 4; ++j) {
                const long double s = cross(a.p[i] - a.p[3], b.p[j] - b.p[0]);
                const int sign = (s > 0) - (s < 0);
                if (sign == 0 || sign == -side) return false;
                side = sign;
            }
        }
        return true;
    }

    int splits_ = 0;
};

}  // namespace

std::optional<Vec2d> self_crossing(const PlaneCurve& outline) {
    // Uses units of the curve's size, so that products neither overflow nor underflow.
    double size = 0.0;
    for (const Vec2d& p : outline.points) size = std::max({size, std::abs(p.x), std::abs(p.y)});
    if (size == 0.0) return std::nullopt;
    const double unit = std::ldexp(1.0, std::ilogb(size));

    std::vector<Piece> pieces;
    pieces.reserve(outline.segments());
    for (std::size_t i = 0; i < outline.segments(); ++i) {
        const auto c = outline.segment(i);
        const auto at = [&](std::size_t k) { return c[k] / unit; };
        const Piece piece = outline.degree == 1 ? Piece{{at(0), at(0), at(1), at(1)}, true}
                                                : Piece{{at(0), at(1), at(2), at(3)}, false};
        if (piece.p[0] == piece.p[3] && outline.degree == 1) continue;
        pieces.push_back(piece);
    }
    Search search;
    for (const Piece& piece : pieces) {
        if (auto found = search.loop(piece, 0)) return *found * unit;
    }

    // Sweeps over x, so that only pieces with overlapping boxes are compared.
    const std::size_t n = pieces.size();
    std::vector<Extent> boxes(n);
    std::vector<std::size_t> order(n);
    for (std::size_t i = 0; i < n; ++i) {
        boxes[i] = bounds(pieces[i]);
        order[i] = i;
    }
    std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
        return boxes[a].min.x != boxes[b].min.x ? boxes[a].min.x < boxes[b].min.x : a < b;
    });
    const auto compare = [&](std::size_t a, std::size_t b) -> std::optional<Vec2d> {
        if (!overlap(boxes[a], boxes[b])) return std::nullopt;
        const bool a_then_b = (a + 1) % n == b;
        const bool b_then_a = (b + 1) % n == a;
        if (a_then_b && b_then_a) {
            // Two pieces that share both joints: halve one, so that each part shares one.
            const auto [b0, b1] = halves(pieces[b]);
            if (auto found = search.pair(pieces[a], b0, true, 0)) return found;
            return search.pair(b1, pieces[a], true, 0);
        }
        if (a_then_b) return search.pair(pieces[a], pieces[b], true, 0);
        if (b_then_a) return search.pair(pieces[b], pieces[a], true, 0);
        return search.pair(pieces[a], pieces[b], false, 0);
    };
    for (std::size_t i = 0; i < n; ++i) {
        const double right = boxes[order[i]].max.x;
        for (std::size_t j = i + 1; j < n && boxes[order[j]].min.x <= right; ++j) {
            if (auto found = compare(order[i], order[j])) return *found * unit;
        }
    }
    return std::nullopt;
}

}  // namespace lancer
