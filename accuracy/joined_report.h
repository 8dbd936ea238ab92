// What the parts of a picture together say of its error.
//
// Each part was made for the same error and drew the pixels of its audits from its own, apart from
// all other parts: they are the strata of one audit of the whole. A draw of a part stands for the
// part's pixels, so the parts' means are weighted by their numbers of pixels.
#pragma once

#include <span>

#include "accuracy/error_picture.h"
#include "accuracy/error_sums.h"

namespace lancer::accuracy {

/// The report on the picture that these parts are, one at least, all of them made for one goal. Of
/// a single part that is the whole it is what the whole tells of itself.
ErrorReport joined_report(std::span<const ErrorSums> parts);

/// What the picture was predicted to be off by, and what its rays cost, from the sums.
void tell_costs(ErrorReport& report, std::span<const ErrorSums> parts);

}  // namespace lancer::accuracy
