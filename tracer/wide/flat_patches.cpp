#include "tracer/wide/flat_patches.h"

#include <bit>
#include <cstddef>

#include "tracer/wide/flat_world.h"

namespace lancer::wide {

// Level code reads pieces where they lie.
static_assert(sizeof(PatchPiece) == sizeof(splines::Piece<double>));
static_assert(offsetof(PatchPiece, c) == offsetof(splines::Piece<double>, c));
static_assert(sizeof(PieceFrame) == sizeof(splines::PieceFrame<double>));
static_assert(offsetof(PieceFrame, row_size) == offsetof(splines::PieceFrame<double>, row_size));
static_assert(offsetof(PieceFrame, low) == offsetof(splines::PieceFrame<double>, low));
static_assert(offsetof(PieceFrame, high) == offsetof(splines::PieceFrame<double>, high));
static_assert(offsetof(PieceFrame, middle) == offsetof(splines::PieceFrame<double>, middle));
static_assert(offsetof(PieceFrame, uneven) == offsetof(splines::PieceFrame<double>, uneven));
static_assert(offsetof(PieceFrame, slope) == offsetof(splines::PieceFrame<double>, slope));
static_assert(sizeof(PatchHome) == sizeof(PieceTree<double>::Home));
static_assert(offsetof(PatchHome, anchor) == offsetof(PieceTree<double>::Home, anchor));
static_assert(offsetof(PatchHome, size) == offsetof(PieceTree<double>::Home, size));
static_assert(offsetof(PatchHome, points) == offsetof(PieceTree<double>::Home, points));

PatchShape shape_of(const PieceTree<double>& tree) {
    PatchShape shape{};
    shape.tree = tree_of(tree.bvh);
    shape.order = tree.bvh.order.data();
    shape.pieces = reinterpret_cast<const PatchPiece*>(tree.pieces.data());
    shape.frames = reinterpret_cast<const PieceFrame*>(tree.frames.data());
    shape.home = tree.home.data();
    shape.homes = reinterpret_cast<const PatchHome*>(tree.homes.data());
    shape.home_count = tree.homes.size();
    return shape;
}

void cross_piece(const PatchPiece& piece, const PieceLine& line, const PlanePart* part,
                 const HitSink& sink) {
    const PieceStart<double> start(Vec3d(line.at[0], line.at[1], line.at[2]), line.noise);
    const Shear<double> shear{line.x, line.y, line.z, line.sx, line.sy, line.sz};
    const PieceSight<double> sight(reinterpret_cast<const splines::Piece<double>&>(piece), 0, start,
                                   shear);
    const auto report = [&](const Crossing<double>& c, double u, double v) {
        sink.add(sink.self, {c.t, c.error, u, v, none, c.face, c.entering});
    };
    if (part == nullptr)
        sight.search(report);
    else
        sight.search(std::bit_cast<splines::PlaneNet<double>>(part->net), part->u, part->v,
                     part->du, part->dv, report);
}

}  // namespace lancer::wide
