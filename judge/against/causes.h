// One cause for all that differs between two pictures, in words.
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

/// What most likely makes the other picture what it is: the explanation that repairs nearly all
/// pixels which differ and spoils none. Nothing where there is no single one; asked only of
/// pictures that do not agree. The work is bounded: some ten thousand points, some hundred
/// variants of the scene, nearly all of which are dropped after some hundred points. `job.view` is
/// that of the pictures, and `judgement` is of them.
///
/// \param ours    times the exposure
/// \param probe   gives `ours` at the pixels' centres, as judge_pictures has it
std::optional<Cause> likely_cause(const ValidationJob& job, const Image& ours, const Image& theirs,
                                  const Judgement& judgement, const Reading& reading, bool clipped,
                                  const ProbeFunction& probe);

/// Whether the shift that registration found makes the pictures more alike where they differ. Over
/// differences of another cause it finds any.
bool shift_brings_nearer(const Image& ours, const Image& theirs, const Judgement& judgement,
                         const ProbeFunction& probe);

/// The objects that the unexplained pixels show first, those of most pixels in front; at most
/// three.
struct Suspect {
    std::size_t object = 0;  ///< index into Scene::objects
    std::size_t pixels = 0;
};
std::vector<Suspect> suspects_of(const Judgement& judgement, const ProbeFunction& probe);

}  // namespace lancer::judge
