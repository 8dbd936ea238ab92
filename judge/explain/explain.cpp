#include "judge/explain/explain.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "judge/explain/outlier.h"
#include "judge/explain/pixel.h"
#include "judge/explain/verdict.h"
#include "reference/compare/compare.h"

namespace lancer::judge {

namespace {

/// A small shift cannot change a smooth surface by more than this. Pixels that differ more are left
/// out of registration.
constexpr double no_shift = 0.01;

/// The indices of the pixels to examine. Pixels come first where the other program's value differs
/// from ours even when coincident faces are told apart. For the others, its second picture is
/// sufficient evidence if the rays run out.
std::vector<std::size_t> asked_about(const Image& ours, const std::vector<double>& differences,
                                     const Thresholds& limits, const SecondLook& second) {
    std::vector<std::size_t> pixels;
    bool any = false;
    for (std::size_t i = 0; i < differences.size(); ++i) {
        if (differences[i] <= std::min(limits.tight, limits.interior)) continue;
        pixels.push_back(i);
        any = any || differences[i] > limits.interior;
    }
    if (!any || !second.resolved) return pixels;
    const std::vector<double> told_apart =
        reference::pixel_differences(ours, second.resolved().theirs);
    std::stable_partition(pixels.begin(), pixels.end(), [&](std::size_t i) {
        return differences[i] > limits.interior && told_apart[i] > limits.interior;
    });
    return pixels;
}

/// The picture with the values of POV-Ray's rules at the pixels that registration uses and that
/// differ by at least `least`. Otherwise a rule that dims a slope would look like a shift.
Image drawn_anew(Image picture, const ProbeFunction& by_rules, const Mask& skip,
                 const std::vector<double>& differences, double least) {
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const std::size_t i = index_of(picture, x, y);
            if (skip[i] != 0 || differences[i] < least) continue;
            const Color color = by_rules(x + 0.5, y + 0.5).color;
            for (int c = 0; c < 3; ++c) picture.pixel(x, y)[c] = color[c];
        }
    }
    return picture;
}

}  // namespace

std::string class_name(PixelClass pixel_class) {
    switch (pixel_class) {
        case PixelClass::agrees:
            return "agrees";
        case PixelClass::silhouette:
            return "silhouette";
        case PixelClass::shadow:
            return "shadow";
        case PixelClass::texture:
            return "texture";
        case PixelClass::secondary:
            return "reflected edge";
        case PixelClass::steep:
            return "steep";
        case PixelClass::coincident:
            return "coincident surfaces";
        case PixelClass::outlier:
            return "reference outlier";
        case PixelClass::known:
            return "known difference";
        case PixelClass::unexplained:
            return "unexplained";
    }
    return {};
}

bool needs_povray(PixelClass c) {
    return c == PixelClass::known || c == PixelClass::coincident || c == PixelClass::outlier;
}

Judgement judge_pictures(const Image& ours, const Image& theirs, const ProbeFunction& probe,
                         const Thresholds& limits, const SecondLook& second,
                         std::uint64_t most_rays) {
    assert(ours.width == theirs.width && ours.height == theirs.height);
    Judgement result;
    const std::vector<double> differences = reference::pixel_differences(ours, theirs);
    const Mask edges = find_edges(ours, probe);
    result.pixels = differences.size();
    result.edge_pixels =
        static_cast<std::size_t>(std::count(edges.begin(), edges.end(), std::uint8_t{1}));
    result.classes.assign(differences.size(), PixelClass::agrees);

    const auto counted = [&](const ProbeFunction& given) {
        return !given ? ProbeFunction() : ProbeFunction([&](double x, double y) {
            Probe sample = given(x, y);
            result.rays += sample.rays;
            return sample;
        });
    };
    const ProbeFunction look = counted(probe);
    const SecondLook look_again{counted(second.by_rules), counted(second.without), second.around,
                                second.resolved};
    Mask skip = edges;
    const std::size_t most_outliers = allowed_pixels(limits.outlier_share, result.pixels);
    std::size_t asked = 0;
    std::vector<Offset> offsets;
    std::vector<DifferentPixel> slight;  // not yet shown to have a cause
    bool coincident = false;
    for (const std::size_t i : asked_about(ours, differences, limits, second)) {
        DifferentPixel pixel;
        pixel.x = static_cast<int>(i % static_cast<std::size_t>(ours.width));
        pixel.y = static_cast<int>(i / static_cast<std::size_t>(ours.width));
        pixel.difference = differences[i];
        pixel.ours = color_at(ours, pixel.x, pixel.y);
        pixel.theirs = color_at(theirs, pixel.x, pixel.y);
        const bool may_look = result.rays < most_rays;
        if (pixel.difference <= limits.interior) {
            if (may_look && is_known(pixel, limits.tight, limits, look_again) &&
                is_ours(pixel, limits, look))
                result.classes[i] = PixelClass::known;
            else
                slight.push_back(pixel);
            continue;
        }
        if ((may_look || look_again.resolved) && is_ours(pixel, limits, look)) {
            if (may_look) classify(pixel, look, limits, look_again);
            // An edge further away than rounding can move it is weaker evidence than the resolved
            // picture.
            const bool doubtful = pixel.pixel_class == PixelClass::unexplained ||
                                  (is_explained(pixel.pixel_class) &&
                                   std::hypot(pixel.offset.x, pixel.offset.y) > limits.rounding);
            if (doubtful && look_again.resolved &&
                is_coincident(pixel, limits.interior, look_again)) {
                pixel.pixel_class = PixelClass::coincident;
                pixel.offset = {};
                coincident = true;
            }
            if (pixel.pixel_class == PixelClass::unexplained && may_look && look_again.resolved)
                explain_told_apart(pixel, look, limits, look_again);
            if (pixel.pixel_class == PixelClass::unexplained && may_look && look_again.around &&
                asked < most_outliers) {
                ++asked;
                if (is_outlier(pixel, look, limits, look_again))
                    pixel.pixel_class = PixelClass::outlier;
            }
        }
        if (pixel.pixel_class == PixelClass::unexplained && !may_look) ++result.not_looked_at;
        if (is_explained(pixel.pixel_class)) {
            offsets.push_back(pixel.offset);
            ++result.explained;
            if (std::hypot(pixel.offset.x, pixel.offset.y) > limits.rounding) ++result.displaced;
        }
        if (pixel.pixel_class != PixelClass::unexplained || pixel.difference > no_shift)
            skip[i] = 1;
        result.classes[i] = pixel.pixel_class;
        result.different.push_back(pixel);
    }
    std::sort(result.different.begin(), result.different.end(),
              [](const DifferentPixel& a, const DifferentPixel& b) {
                  return a.y != b.y ? a.y < b.y : a.x < b.x;
              });
    const double slight_share =
        static_cast<double>(slight.size()) / static_cast<double>(differences.size());
    if (look_again.resolved && (coincident || slight_share > 1 - limits.tight_share)) {
        for (const DifferentPixel& pixel : slight) {
            if (is_coincident(pixel, limits.tight, look_again) && is_ours(pixel, limits, look))
                result.classes[index_of(ours, pixel.x, pixel.y)] = PixelClass::coincident;
        }
    }
    for (const PixelClass c : result.classes) ++result.counts[static_cast<std::size_t>(c)];

    measure_interior(result, edges, differences, limits);
    result.edge_shift = mean_offset(offsets);
    const bool by_rules_too = second.by_rules && result.count(PixelClass::known) > 0;
    result.picture_shift = register_pictures(
        by_rules_too ? drawn_anew(ours, look_again.by_rules, skip, differences, limits.tight / 2)
                     : ours,
        theirs, skip);
    decide(result, limits);
    return result;
}

}  // namespace lancer::judge
