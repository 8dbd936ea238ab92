// Validates a scene against a picture that another renderer made.
#pragma once

#include <optional>
#include <string>

#include "judge/against/reading.h"
#include "judge/validate/validate.h"

namespace lancer::judge {

struct AgainstJob {
    ValidationJob scene;  ///< its view has the size only when `size_is_given`
    std::string picture;  ///< file
    Reading reading;
    bool size_is_given = false;
};

/// Renders our picture through the points of the pixels where the other program's rays go, and
/// judges the other picture by it. The rules are those for POV-Ray, without the questions that only
/// POV-Ray can answer. Where the pictures differ, reports the likely cause. The picture's size is
/// the view's unless one is given; its proportions must be those of the scene. A failure is a
/// verdict; throws only std::bad_alloc.
Validation validate_against(const AgainstJob& job);

/// The picture of a scene in a folder: NAME.exr, .tif, .tiff, .png or .ppm, in this order. Throws
/// FileError when there is none.
std::string picture_in_folder(const std::string& folder, const std::string& scene_path);

/// The report, still without entries.
Report against_report(const std::string& lancer_version, const std::string& pictures,
                      const Reading& reading);

}  // namespace lancer::judge
