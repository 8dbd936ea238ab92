// Looks up colours in images, by the rules of POV-Ray's image_map (docs/shading.md).
#pragma once

#include <array>

#include "model/image.h"
#include "model/material.h"
#include "tracer/textures/mapping.h"

namespace lancer {

/// Colour and alpha of a texture at a point; the share 1 - alpha of the light passes.
template <class Real>
struct TextureColor {
    Vec3<Real> color;
    bool has_alpha = false;  ///< `alpha` replaces the material's filter and transmission
    Real alpha{};
};

template <class Real>
struct ImagePattern {
    const Image* image = nullptr;  ///< 3 or 4 channels, not empty
    ImageTexture::Mapping mapping{};
    ImageTexture::Filter filter{};
    ImageTexture::Wrap wrap{};
    Affine<Real> from_uv;  ///< mapping uv: inverse of the texture's transforms, for (u, v, 0)
};

/// The column or row in an image of this size for a number that may lie outside: repeated, or
/// clamped to the nearest.
template <class Real>
int wrapped(Real whole, int size, ImageTexture::Wrap wrap) {
    using std::floor;
    const Real n = static_cast<Real>(size);
    const Real inside = wrap == ImageTexture::Wrap::repeat ? whole - n * floor(whole / n) : whole;
    if (!(inside > 0)) return 0;  // NaN too
    return inside < n ? static_cast<int>(inside) : size - 1;
}

/// A texel, with rows counted from the bottom: red, green, blue, and alpha (0 if there is none).
template <class Real>
std::array<Real, 4> texel(const Image& image, int column, int row_up) {
    const double* p = image.pixel(column, image.height - 1 - row_up);
    return {static_cast<Real>(p[0]), static_cast<Real>(p[1]), static_cast<Real>(p[2]),
            image.channels > 3 ? static_cast<Real>(p[3]) : Real{}};
}

/// Linear in both directions between the centres of the four nearest texels. Alpha is treated as a
/// fourth colour, not multiplied into the others.
template <class Real>
std::array<Real, 4> bilinear(const ImagePattern<Real>& map, Real x, Real y) {
    using std::floor;
    const Image& image = *map.image;
    const Real left = floor(x - Real(0.5));
    const Real below = floor(y - Real(0.5));
    const Real right_share = (x - Real(0.5)) - left;
    const Real upper_share = (y - Real(0.5)) - below;
    const std::array<int, 2> columns{wrapped(left, image.width, map.wrap),
                                     wrapped(left + 1, image.width, map.wrap)};
    const std::array<int, 2> rows{wrapped(below, image.height, map.wrap),
                                  wrapped(below + 1, image.height, map.wrap)};
    std::array<Real, 4> sum{};
    for (std::size_t j = 0; j < 2; ++j) {
        for (std::size_t i = 0; i < 2; ++i) {
            const Real part =
                (i == 0 ? 1 - right_share : right_share) * (j == 0 ? 1 - upper_share : upper_share);
            const std::array<Real, 4> value = texel<Real>(image, columns[i], rows[j]);
            for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += part * value[c];
        }
    }
    return sum;
}

template <class Real>
TextureColor<Real> color_at(const ImagePattern<Real>& map, const ImagePoint<Real>& p) {
    if (map.wrap == ImageTexture::Wrap::once) {
        const auto outside = [](Real c, Real bound) { return c < -bound || c > 1 + bound; };
        if (outside(p.u, p.u_bound) || outside(p.v, p.v_bound))
            return {Vec3<Real>(1), true, Real(0)};
    }
    const Image& image = *map.image;
    const Real width = static_cast<Real>(image.width);
    const Real height = static_cast<Real>(image.height);
    std::array<Real, 4> value;
    if (map.filter == ImageTexture::Filter::nearest) {
        const Real column = whole_part(p.u * width, p.u_bound * width);
        const Real row_up = whole_part(p.v * height, p.v_bound * height);
        value = texel<Real>(image, wrapped(column, image.width, map.wrap),
                            wrapped(row_up, image.height, map.wrap));
    } else {
        value = bilinear(map, p.u * width, p.v * height);
    }
    const auto [red, green, blue, alpha] = value;
    return {{red, green, blue}, image.channels > 3, alpha};
}

}  // namespace lancer
