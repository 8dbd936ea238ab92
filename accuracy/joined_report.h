// The report on the error of a whole picture, from its parts.
//
// All parts were made for the same error, and each drew the pixels of its audits independently
// from its own pixels. So the parts are the strata of one audit of the whole: their means are
// weighted by their numbers of pixels.
#pragma once

#include <span>

#include "accuracy/error_picture.h"
#include "accuracy/error_sums.h"

namespace lancer::accuracy {

/// The report on the picture that consists of these parts. There is at least one, and all were made
/// for the same goal. For a single part that is the whole picture, it is that picture's own report.
ErrorReport joined_report(std::span<const ErrorSums> parts);

/// Fills in the predicted error and the numbers of rays, from the sums.
void tell_costs(ErrorReport& report, std::span<const ErrorSums> parts);

}  // namespace lancer::accuracy
