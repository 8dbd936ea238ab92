// A scene, and a picture of it that any other renderer made.
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

/// Renders ours through the points that the other program is said to look through, and judges the
/// picture by it as POV-Ray's is judged, without what POV-Ray is asked besides; where the two
/// differ the likely cause is told. The picture's size is the view's unless one is given; its
/// proportions must be those of the scene. What goes wrong is a verdict; throws nothing but what
/// memory throws.
Validation validate_against(const AgainstJob& job);

/// The picture of a scene in a folder: NAME.exr, .tif, .tiff, .png or .ppm, in this order. Throws
/// FileError when there is none.
std::string picture_in_folder(const std::string& folder, const std::string& scene_path);

/// The report around the entries.
Report against_report(const std::string& lancer_version, const std::string& pictures,
                      const Reading& reading);

}  // namespace lancer::judge
