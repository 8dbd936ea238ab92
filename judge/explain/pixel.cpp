#include "judge/explain/pixel.h"

#include <cmath>

namespace lancer::judge {

namespace {

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

/// Whether rounding can put the edge on the other side of the centre.
bool is_rounding(const NearbyEdge& edge, const Thresholds& limits) {
    return std::hypot(edge.dx, edge.dy) <= limits.rounding;
}

/// Whether the rules change anything within the radius. This is tested first because a search for
/// edges takes thousands of probes.
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

}  // namespace

bool is_explained(PixelClass c) {
    return c == PixelClass::silhouette || c == PixelClass::shadow || c == PixelClass::texture ||
           c == PixelClass::secondary || c == PixelClass::steep;
}

bool is_ours(const DifferentPixel& pixel, const Thresholds& limits, const ProbeFunction& probe) {
    return distance(probe(pixel.x + 0.5, pixel.y + 0.5).color, pixel.ours) <= limits.tight;
}

bool is_known(const DifferentPixel& pixel, double tolerance, const Thresholds& limits,
              const SecondLook& second) {
    if (!second.by_rules || !second.without) return false;
    const double x = pixel.x + 0.5;
    const double y = pixel.y + 0.5;
    return distance(second.by_rules(x, y).color, pixel.theirs) <= tolerance &&
           distance(second.without(x, y).color, pixel.ours) <= limits.tight;
}

bool is_coincident(const DifferentPixel& pixel, double tolerance, const SecondLook& second) {
    const ResolvedPicture& resolved = second.resolved();
    const Color theirs = color_at(resolved.theirs, pixel.x, pixel.y);
    if (distance(theirs, pixel.ours) <= tolerance) return true;
    const double x = pixel.x + 0.5;
    const double y = pixel.y + 0.5;
    return distance(resolved.by_rules(x, y).color, theirs) <= tolerance &&
           distance(resolved.without(x, y).color, pixel.ours) <= tolerance;
}

void classify(DifferentPixel& pixel, const ProbeFunction& probe, const Thresholds& limits,
              const SecondLook& second) {
    if (is_known(pixel, limits.interior, limits, second)) {
        pixel.pixel_class = PixelClass::known;
        return;
    }
    const double x = pixel.x + 0.5;
    const double y = pixel.y + 0.5;
    auto edge = find_nearby_edge(probe, x, y, pixel.theirs, limits.radius, limits.interior);
    const bool may_lie_elsewhere =
        edge ? !is_rounding(*edge, limits) : part_nearby(probe, second.by_rules, x, y, limits);
    if (second.by_rules && may_lie_elsewhere) {
        // The other program applies its own rules beyond an edge, and to the place of the edge.
        const auto by_rules =
            find_nearby_edge(second.by_rules, x, y, pixel.theirs, limits.radius, limits.interior);
        if (by_rules && (!edge || is_rounding(*by_rules, limits))) {
            edge = by_rules;
            pixel.took_povray = true;
        }
    }
    if (edge) {
        pixel.pixel_class = class_of(edge->kind);
        pixel.offset = {edge->dx, edge->dy};
    } else if (reached_at(probe, x, y, pixel.theirs, limits.digits, limits.interior)) {
        pixel.pixel_class = PixelClass::steep;
    }
}

void explain_told_apart(DifferentPixel& pixel, const ProbeFunction& probe, const Thresholds& limits,
                        const SecondLook& second) {
    DifferentPixel apart = pixel;
    apart.theirs = color_at(second.resolved().theirs, pixel.x, pixel.y);
    classify(apart, probe, limits, {});
    // This does not examine the first picture, which may hold anything. So only an edge at the very
    // centre explains it.
    if (!is_explained(apart.pixel_class) ||
        std::hypot(apart.offset.x, apart.offset.y) > limits.rounding)
        return;
    pixel.pixel_class = apart.pixel_class;
    pixel.offset = apart.offset;
    pixel.took_povray = true;
}

}  // namespace lancer::judge
