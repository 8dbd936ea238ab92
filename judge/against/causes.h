// Finds one cause of all differences between two pictures, in words.
#pragma once

#include <optional>
#include <string>

#include "judge/against/reading.h"
#include "judge/explain/explain.h"
#include "judge/validate/validate.h"

namespace lancer::judge {

struct Cause {
    std::string words;  ///< a sentence without a full stop
    bool is_shift = false;
};

/// The most likely cause of the differences: the explanation that repairs nearly all different
/// pixels and spoils none. Nothing when there is no single one. To be called only for pictures that
/// do not agree. The work is bounded: about ten thousand points and a few hundred variants of the
/// scene, nearly all of which are rejected after a few hundred points. `job.view` is the view of
/// the pictures, and `judgement` is their judgement.
///
/// \param ours    multiplied by the exposure
/// \param probe   gives `ours` at the pixels' centres, as for judge_pictures()
std::optional<Cause> likely_cause(const ValidationJob& job, const Image& ours, const Image& theirs,
                                  const Judgement& judgement, const Reading& reading, bool clipped,
                                  const ProbeFunction& probe);

/// Whether the shift found by registration makes the different pixels more alike. Registration
/// finds a shift even when the differences have another cause.
bool shift_brings_nearer(const Image& ours, const Image& theirs, const Judgement& judgement,
                         const ProbeFunction& probe);

/// The objects that the unexplained pixels show, by decreasing number of pixels; at most three.
struct Suspect {
    std::size_t object = 0;  ///< index into Scene::objects
    std::size_t pixels = 0;
};
std::vector<Suspect> suspects_of(const Judgement& judgement, const ProbeFunction& probe);

}  // namespace lancer::judge
