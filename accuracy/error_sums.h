// What the report on a picture's error rests on, summed: that of a picture in parts is told from
// the sums of its parts, which their files keep.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "accuracy/audit.h"
#include "accuracy/off_audit.h"
#include "accuracy/rare_light.h"

namespace lancer::accuracy {

/// The same where a share of pixels off was asked for.
struct OffSums {
    double asked = 0;      ///< share of the pixels
    double steps = 0;      ///< of 8 bits
    double predicted = 0;  ///< pixels, from the picture's own samples
    OffCount printed;      ///< of the audit that is printed
};

struct ErrorSums {
    double pixels = 0;
    double asked = 0;         ///< as in ErrorReport
    bool audited = false;     ///< there are draws, unless rare_light forbade them
    bool rare_light = false;  ///< specks were met that forbid to tell of the whole picture
    TermSums deciding;        ///< of the last audit that decided
    TermSums printed;         ///< of the one that is printed
    double predicted = 0;     ///< squared error, summed over pixels and channels
    double scores = 0;        ///< the same for one sample a pixel
    Specks specks;
    std::vector<PixelShare> dominant;  ///< as in ErrorReport
    RayCounts picture;
    RayCounts deciding_rays;
    RayCounts printed_rays;
    std::optional<OffSums> off;
};

/// One line without a line feed, with every bit of the numbers.
std::string to_text(const ErrorSums& sums);
/// What to_text() told; nothing when it did not.
std::optional<ErrorSums> error_sums_of(std::string_view text);

}  // namespace lancer::accuracy
