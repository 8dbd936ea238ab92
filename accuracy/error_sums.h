// The sums from which the report on a picture's error is made. The file of each part of a picture
// keeps them, so that the report on the whole can be made from the parts.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "accuracy/audit.h"
#include "accuracy/off_audit.h"
#include "accuracy/rare_light.h"

namespace lancer::accuracy {

/// The sums where a share of pixels was asked for.
struct OffSums {
    double asked = 0;      ///< share of the pixels
    double steps = 0;      ///< threshold in steps of 8 bits
    double predicted = 0;  ///< number of pixels, predicted from the picture's own samples
    OffCount printed;      ///< from the audit that is printed
};

struct ErrorSums {
    double pixels = 0;
    double asked = 0;         ///< as in ErrorReport
    bool audited = false;     ///< there are draws, unless rare_light forbade them
    bool rare_light = false;  ///< the specks that were met forbid a told error of the whole picture
    TermSums deciding;        ///< of the last deciding audit
    TermSums printed;         ///< of the audit that is printed
    double predicted = 0;     ///< squared error, summed over pixels and channels
    double scores = 0;        ///< the same for one sample per pixel
    Specks specks;
    std::vector<PixelShare> dominant;  ///< as in ErrorReport
    RayCounts picture;
    RayCounts deciding_rays;
    RayCounts printed_rays;
    std::optional<OffSums> off;
};

/// One line without a line feed. It keeps every bit of the numbers.
std::string to_text(const ErrorSums& sums);
/// Reads a line of to_text(). Empty when the text is not such a line or no report can be made of
/// it.
std::optional<ErrorSums> error_sums_of(std::string_view text);

}  // namespace lancer::accuracy
