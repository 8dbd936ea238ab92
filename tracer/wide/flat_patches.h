// Patches as plain arrays, and the scalar code for their pieces: what stands behind
// ExactMethods::patch() and piece_crossings().
#pragma once

#include "tracer/shapes/bicubic.h"
#include "tracer/wide/exact_methods.h"

namespace lancer::wide {

/// Refers to the tree.
PatchShape shape_of(const PieceTree<double>& tree);

void cross_piece(const PatchPiece& piece, const PieceLine& line, const PlanePart* part,
                 const HitSink& sink);

}  // namespace lancer::wide
