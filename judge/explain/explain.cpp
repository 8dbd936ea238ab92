#include "judge/explain/explain.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "judge/explain/outlier.h"
#include "reference/compare/compare.h"

namespace lancer::judge {

namespace {

/// A small shift makes no such difference on a smooth surface: what does is left out of
/// registration.
constexpr double no_shift = 0.01;

PixelClass class_of(EdgeKind kind) {
    switch (kind) {
        case EdgeKind::silhouette:
            return PixelClass::silhouette;
        case EdgeKind::shadow:
            return PixelClass::shadow;
        case EdgeKind::texture:
            return PixelClass::texture;
        case EdgeKind::secondary:
            return PixelClass::secondary;
    }
    return PixelClass::unexplained;
}

bool is_explained(PixelClass c) {
    return c == PixelClass::silhouette || c == PixelClass::shadow || c == PixelClass::texture ||
           c == PixelClass::secondary || c == PixelClass::steep;
}

/// Whether our picture is what our renderer gives: were it not, its looks would explain nothing.
bool is_ours(const DifferentPixel& pixel, const Thresholds& limits, const ProbeFunction& probe) {
    return distance(probe(pixel.x + 0.5, pixel.y + 0.5).color, pixel.ours) <= limits.tight;
}

/// Whether the other program's rules, and nothing else, make the difference to within `tolerance`.
bool is_known(const DifferentPixel& pixel, double tolerance, const Thresholds& limits,
              const SecondLook& second) {
    if (!second.by_rules || !second.without) return false;
    const double x = pixel.x + 0.5;
    const double y = pixel.y + 0.5;
    return distance(second.by_rules(x, y).color, pixel.theirs) <= tolerance &&
           distance(second.without(x, y).color, pixel.ours) <= limits.tight;
}

/// Whether the other program has our value once coincident faces are told apart.
bool is_coincident(const DifferentPixel& pixel, double tolerance, const SecondLook& second) {
    const ResolvedPicture& resolved = second.resolved();
    const Color theirs = color_at(resolved.theirs, pixel.x, pixel.y);
    if (distance(theirs, pixel.ours) <= tolerance) return true;
    const double x = pixel.x + 0.5;
    const double y = pixel.y + 0.5;
    return distance(resolved.by_rules(x, y).color, theirs) <= tolerance &&
           distance(resolved.without(x, y).color, pixel.ours) <= tolerance;
}

/// The pixels that are asked about. Rays are spent first where the other program has another value
/// than ours although coincident faces were told apart: elsewhere its picture tells enough, if need
/// be.
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

/// Whether rounding can put the edge on the other side of the centre.
bool is_rounding(const Crossing& crossing, const Thresholds& limits) {
    return std::hypot(crossing.dx, crossing.dy) <= limits.rounding;
}

/// Whether the rules change anything within the radius: a search for edges is thousands of looks.
bool part_nearby(const ProbeFunction& probe, const ProbeFunction& by_rules, double x, double y,
                 const Thresholds& limits) {
    if (!by_rules) return false;
    const auto part = [&](double dx, double dy) {
        const double px = x + dx * limits.radius;
        const double py = y + dy * limits.radius;
        return distance(probe(px, py).color, by_rules(px, py).color) > limits.tight;
    };
    if (part(0, 0)) return true;
    for (const double far : {0.25, 0.5, 1.0}) {
        for (int i = -1; i <= 1; ++i) {
            for (int j = -1; j <= 1; ++j) {
                if ((i != 0 || j != 0) && part(i * far, j * far)) return true;
            }
        }
    }
    return false;
}

/// What explains that our pixel is not `pixel.theirs`.
void classify(DifferentPixel& pixel, const ProbeFunction& probe, const Thresholds& limits,
              const SecondLook& second) {
    if (is_known(pixel, limits.interior, limits, second)) {
        pixel.pixel_class = PixelClass::known;
        return;
    }
    const double x = pixel.x + 0.5;
    const double y = pixel.y + 0.5;
    auto crossing = find_crossing(probe, x, y, pixel.theirs, limits.radius, limits.interior);
    const bool may_lie_elsewhere = crossing ? !is_rounding(*crossing, limits)
                                            : part_nearby(probe, second.by_rules, x, y, limits);
    if (second.by_rules && may_lie_elsewhere) {
        // The other program follows its own rules behind an edge, too, and where it lies.
        const auto by_rules =
            find_crossing(second.by_rules, x, y, pixel.theirs, limits.radius, limits.interior);
        if (by_rules && (!crossing || is_rounding(*by_rules, limits))) {
            crossing = by_rules;
            pixel.took_povray = true;
        }
    }
    if (crossing) {
        pixel.pixel_class = class_of(crossing->kind);
        pixel.offset = {crossing->dx, crossing->dy};
    } else if (reached_at(probe, x, y, pixel.theirs, limits.digits, limits.interior)) {
        pixel.pixel_class = PixelClass::steep;
    }
}

/// The other program may have a value there that is neither, because an edge passes the centre:
/// that explains the pixel, and counts as an edge does.
void explain_told_apart(DifferentPixel& pixel, const ProbeFunction& probe, const Thresholds& limits,
                        const SecondLook& second) {
    DifferentPixel apart = pixel;
    apart.theirs = color_at(second.resolved().theirs, pixel.x, pixel.y);
    classify(apart, probe, limits, {});
    // The first picture, which is not looked at here, may hold anything: only an edge at the very
    // centre excuses it.
    if (!is_explained(apart.pixel_class) ||
        std::hypot(apart.offset.x, apart.offset.y) > limits.rounding)
        return;
    pixel.pixel_class = apart.pixel_class;
    pixel.offset = apart.offset;
    pixel.took_povray = true;
}

/// The picture, where registration looks and differs by `least`, as the rules have it: a rule that
/// dims a slope would else pass for a shift.
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

/// Everything that is told about pixels away from edges.
void measure_interior(Judgement& result, const Mask& edges, const std::vector<double>& differences,
                      const Thresholds& limits) {
    std::vector<double> interior;
    for (std::size_t i = 0; i < differences.size(); ++i) {
        const PixelClass c = result.classes[i];
        if (edges[i] == 0 && (c == PixelClass::agrees || c == PixelClass::unexplained)) {
            interior.push_back(differences[i]);
        }
    }
    result.interior_pixels = interior.size();
    if (interior.empty()) return;
    const auto within = std::count_if(interior.begin(), interior.end(),
                                      [&](double d) { return d <= limits.tight; });
    result.tight_share = static_cast<double>(within) / static_cast<double>(interior.size());
    result.interior_max = *std::max_element(interior.begin(), interior.end());
    result.interior_p999 = reference::percentile(interior, 0.999);
}

/// A share of a count as a whole number of pixels; one is always allowed, or a small scene with one
/// edge exactly through a pixel's centre could never pass.
std::size_t allowed_pixels(double share, std::size_t of) {
    return std::max<std::size_t>(1, static_cast<std::size_t>(share * static_cast<double>(of)));
}

void decide(Judgement& result, const Thresholds& limits) {
    auto& failures = result.failures;
    const std::size_t unexplained = result.count(PixelClass::unexplained);
    if (unexplained > limits.unexplained) {
        failures.push_back(fmt::format("{} unexplained pixels differ by more than {:g}, {} allowed",
                                       unexplained, limits.interior, limits.unexplained));
        if (result.not_looked_at > 0) {
            failures.push_back(
                fmt::format("{} of them were not looked at: explaining ended after {} rays",
                            result.not_looked_at, result.rays));
        }
    }
    if (result.tight_share < limits.tight_share) {
        failures.push_back(
            fmt::format("{:.3f} % of the pixels away from edges are within {:g}, {:g} % needed",
                        result.tight_share * 100, limits.tight, limits.tight_share * 100));
    }
    const std::size_t most = allowed_pixels(limits.explained_share, result.edge_pixels);
    if (result.explained > most) {
        failures.push_back(fmt::format(
            "{} pixels are explained by edges, at most {} are allowed ({:g} % of {} edge pixels)",
            result.explained, most, limits.explained_share * 100, result.edge_pixels));
    }
    const std::size_t most_displaced = allowed_pixels(limits.displaced_share, result.edge_pixels);
    if (result.displaced > most_displaced) {
        failures.push_back(fmt::format(
            "{} edges lie more than {:g} pixel apart in the two pictures, at most {} may",
            result.displaced, limits.rounding, most_displaced));
    }
    if (result.edge_shift.is_significant(limits.rounding, 3)) {
        failures.push_back(fmt::format(
            "the explaining edges all lie to one side, by ({:.2g}, {:.2g}) pixel on average",
            result.edge_shift.x, result.edge_shift.y));
    }
    if (result.picture_shift.is_significant(limits.shift, 5)) {
        result.shift_failure =
            fmt::format("the other picture is shifted by ({:.2g}, {:.2g}) pixel, {:g} allowed",
                        result.picture_shift.x, result.picture_shift.y, limits.shift);
        failures.push_back(result.shift_failure);
    }
    result.pass = failures.empty();
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
    std::vector<DifferentPixel> slight;  // not shown to be anything yet
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
            // An edge that rounding cannot have moved so far explains less than a picture does.
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
