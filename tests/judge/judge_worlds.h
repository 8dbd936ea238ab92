// Judgements of pictures by the tests' small tracer.
#pragma once

#include <string>

#include "judge/explain/explain.h"
#include "tests/judge/tiny_tracer.h"

namespace lancer::judge {

/// The judgement of a picture of `other`, as if another program had rendered `world`.
inline Judgement judge_worlds(const tiny::World& world, const tiny::World& other,
                              const Thresholds& limits = {}) {
    return judge_pictures(tiny::Tracer(world).render(), tiny::Tracer(other).render(true),
                          tiny::probe_of(world), limits);
}

inline std::string summary(const Judgement& j) {
    std::string text;
    for (const std::string& failure : j.failures) text += failure + "\n";
    for (std::size_t i = 0; i < pixel_classes; ++i) {
        text += class_name(static_cast<PixelClass>(i)) + " " + std::to_string(j.counts[i]) + "\n";
    }
    text += "edge pixels " + std::to_string(j.edge_pixels) + ", shift " +
            std::to_string(j.picture_shift.x) + " " + std::to_string(j.picture_shift.y) + " +- " +
            std::to_string(j.picture_shift.error_x) + "\n";
    return text;
}

}  // namespace lancer::judge
