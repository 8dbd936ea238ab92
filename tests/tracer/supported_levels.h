// One picture on each level of rays side by side, held against one ray at a time.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tracer/render.h"

namespace lancer {

/// The levels that the processor at hand has, without the scalar one.
inline std::vector<Level> supported_wide_levels() {
    std::vector<Level> levels;
    for (const Level level : {Level::avx2, Level::avx512})
        if (is_supported(level)) levels.push_back(level);
    return levels;
}

/// Bytes and counts of the picture on each level against the scalar one's.
///
/// \return whether the scene's rays go side by side at all
inline bool expect_same_on_all_levels(const Scene& scene, const std::string& what, View view) {
    Settings settings = scene.settings;
    settings.threads = 1;
    RayCounts one_by_one;
    const Image expected = compile(scene, settings, Level::scalar)->render(view, {}, one_by_one);
    bool wide = false;
    for (const Level level : supported_wide_levels()) {
        const auto renderer = compile(scene, settings, level);
        if (renderer->level() == Level::scalar) continue;
        wide = true;
        RayCounts counts;
        const Image image = renderer->render(view, {}, counts);
        EXPECT_TRUE(image.data == expected.data) << what << " on " << name_of(level);
        EXPECT_EQ(counts.primary, one_by_one.primary) << what << " on " << name_of(level);
        EXPECT_EQ(counts.shadow, one_by_one.shadow) << what << " on " << name_of(level);
        EXPECT_EQ(counts.reflected, one_by_one.reflected) << what << " on " << name_of(level);
        EXPECT_EQ(counts.transmitted, one_by_one.transmitted) << what << " on " << name_of(level);
        EXPECT_EQ(counts.media_lost, one_by_one.media_lost) << what << " on " << name_of(level);
    }
    return wide;
}
inline bool expect_same_on_all_levels(const Scene& scene, const std::string& what) {
    return expect_same_on_all_levels(scene, what, {0, scene.width, scene.height, {}, false});
}

}  // namespace lancer
