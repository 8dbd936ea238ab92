// Cuts a patch's true surface into pieces. Only the files that instantiate it include it.
#pragma once

#include <cmath>

#include "model/patch_net.h"
#include "tracer/bvh/build.h"
#include "tracer/shapes/bicubic.h"

namespace lancer {
namespace bicubic_build {

/// How much a piece's slopes may differ from their mean. A larger value gives fewer pieces but more
/// subdivision per ray. It was chosen by measurements; the picture does not depend on it.
inline constexpr double evenness = 0.3;
/// Poles and folds are never even. There rays subdivide further.
inline constexpr int most_cuts = 8;

inline Vec3d scaled_point(const Vec3d& p, int exponent) {
    return {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
}

}  // namespace bicubic_build

template <class Real>
PieceTree<Real> make_piece_tree(const Patch& patch, int exponent) {
    using namespace bicubic_build;
    const BezierNet net = bezier_net(patch);
    PieceTree<Real> tree;
    tree.columns = static_cast<Real>(net.columns);
    tree.rows = static_cast<Real>(net.rows);
    std::vector<Bounds<Real>> boxes;
    for (std::size_t i = 0; i < net.rows; ++i) {
        for (std::size_t j = 0; j < net.columns; ++j) {
            const BezierPatch from = net.patch(i, j);
            typename PieceTree<Real>::Home home;
            home.anchor = convert<Real>(scaled_point(from[0], exponent));
            home.column = static_cast<Real>(j);
            home.row = static_cast<Real>(i);
            home.size = 0;
            splines::Piece<Real> whole{{}, 0, 0, 1, 1};
            for (std::size_t k = 0; k < 16; ++k) {
                home.points[k] = convert<Real>(scaled_point(from[k], exponent)) - home.anchor;
                home.size = std::max(home.size, max_component(absolute(home.points[k])));
                for (int c = 0; c < 3; ++c)
                    whole.c[static_cast<std::size_t>(c)][k] = home.points[k][c];
            }
            splines::cut(whole, static_cast<Real>(evenness), most_cuts, tree.pieces);
            tree.homes.push_back(home);
            for (std::size_t k = tree.home.size(); k < tree.pieces.size(); ++k) {
                tree.frames.emplace_back(tree.pieces[k]);
                Bounds<Real> box;
                for (std::size_t p = 0; p < 16; ++p) {
                    const auto& c = tree.pieces[k].c;
                    box.extend(Vec3<Real>(c[0][p], c[1][p], c[2][p]));
                }
                // The true points lie within this distance of the rounded ones.
                const Vec3<Real> pad(gamma<Real>(32) * home.size);
                boxes.push_back({home.anchor + (box.min - pad), home.anchor + (box.max + pad)});
            }
            tree.home.resize(tree.pieces.size(), static_cast<std::uint32_t>(tree.homes.size() - 1));
        }
    }
    for (Bounds<Real>& box : boxes) box = widened(box);
    tree.bvh = build_bvh(std::move(boxes), 1, 1);
    return tree;
}

template <class Real>
BicubicSurface<Real>::BicubicSurface(Patch patch, int exponent)
    : patch_(std::move(patch)), exponent_(exponent) {
    for (const Vec3d& p : patch_.control)
        bounds_.extend(convert<Real>(bicubic_build::scaled_point(p, exponent)));
}

template <class Real>
const PieceTree<Real>& BicubicSurface<Real>::build() const {
    const std::lock_guard lock(building_);
    if (tree_ == nullptr) {
        tree_ = std::make_unique<const PieceTree<Real>>(make_piece_tree<Real>(patch_, exponent_));
        ready_.store(tree_.get(), std::memory_order_release);
    }
    return *tree_;
}

}  // namespace lancer
