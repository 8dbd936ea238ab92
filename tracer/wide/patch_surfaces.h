// Eight hits with one piece of a patch become surfaces: bicubic_point() for lanes.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// \return hits that are left to scalar code
[[gnu::noinline]] inline Mask put_piece(const Job& job, const Patch& patch, const NearestHits& hits,
                                        Mask mask, Surfaces& s) {
    const int any = __builtin_ctz(mask);
    PatchShape shape;
    job.exact->patch(hits.item[any], shape);
    const PatchPiece& piece = shape.pieces[hits.face[any]];
    const PatchHome& home = shape.homes[shape.home[hits.face[any]]];
    const CubicBases bu(hits.u);
    const CubicBases bv(hits.v);
    const BicubicValues x(piece.c[0], bu, bv);
    const BicubicValues y(piece.c[1], bu, bv);
    const BicubicValues z(piece.c[2], bu, bv);
    const Vectors anchor = all(home.anchor);
    const Vectors offset{x.value, y.value, z.value};
    const Vectors du{x.du, y.du, z.du};
    const Vectors dv{x.dv, y.dv, z.dv};
    const Vectors normal = cross(du, dv);
    const Numbers least = bound<64>() * dot(du, du) * dot(dv, dv) * bound<64>();
    Mask odd = ~less(least, dot(normal, normal));
    const Numbers error = all(gamma<double, 32> * home.size);
    s.note(mask, anchor, offset, error);
    if (patch.frame == nothing) {
        const Vectors turned = unit(normal, odd);
        put(mask & ~odd, two_sum(anchor, offset), error, turned, s);
    } else {
        const Frame& frame = job.scene->frames[patch.frame];
        const Moved moved(frame, anchor, offset, error);
        const Vectors turned = unit(map_transposed(frame.linear_inverse, normal), odd);
        put(mask & ~odd, moved.place, moved.error, turned, s);
    }
    return mask & odd;
}

}  // namespace lancer::wide::LANCER_LEVEL
