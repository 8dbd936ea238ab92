// Pictures of the stages, and how they are compared.
#pragma once

#include "model/image.h"
#include "tests/extremes/stage.h"
#include "tracer/render.h"

namespace lancer::extremes {

/// The picture, after a check that it holds no NaN and that no body was lost on the way.
Image picture(const Scene& scene, Precision precision = Precision::double_);
/// The same in 113 bits, some forty times slower.
Image quad_picture(const Scene& scene);

/// Pixels that differ by more than 1/255 in a channel, both clipped to [0, 1].
int wrong(const Image& a, const Image& b);
/// Pixels that differ at all.
int different(const Image& a, const Image& b);
/// Pixels that are not the first one's colour, with the same measure as wrong().
int not_uniform(const Image& a);
int wrong(const Image& a, const Color& everywhere);

}  // namespace lancer::extremes
