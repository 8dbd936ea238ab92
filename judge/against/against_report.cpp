#include <fmt/format.h>

#include "judge/against/against.h"
#include "judge/report/html.h"
#include "judge/validate/validation_text.h"

namespace lancer::judge {

namespace {

std::string encoding_words(const Encoding& encoding) {
    switch (encoding.kind) {
        case Encoding::Kind::automatic:
            return "by the curve that each file names (whole numbers without one are sRGB, floats "
                   "linear)";
        case Encoding::Kind::linear:
            return "as numbers that are linear light";
        case Encoding::Kind::srgb:
            return "by the sRGB curve";
        case Encoding::Kind::gamma:
            return fmt::format("as numbers to the power of {:g}", encoding.exponent);
    }
    return {};
}

}  // namespace

Report against_report(const std::string& lancer_version, const std::string& pictures,
                      const Reading& reading) {
    Report report;
    const Thresholds defaults;
    report.title = "Lancer against " + pictures;
    report.left_name = "Lancer";
    report.right_name = "picture";
    report.columns = validation_columns("picture");
    report.histogram_marks = {defaults.tight, defaults.interior};
    report.about = {
        {"Programs", fmt::format("Lancer {}, in double precision; the other pictures are files, "
                                 "made by whatever program.",
                                 lancer_version)},
        {"What is assumed",
         fmt::format("One ray through each pixel, at ({:g}, {:g}) from its upper left corner, in "
                     "both pictures; light in both times {:g}; the scene's depth of recursion; the "
                     "formulas of the shading page. The pictures were read {}, and where none of "
                     "their values is above 1, ours are clipped there.",
                     reading.center_x, reading.center_y, reading.exposure,
                     encoding_words(reading.encoding))},
        {"Judgement",
         fmt::format(
             "A pixel whose largest channel differs by more than {} must be explained: an edge of "
             "geometry, shadow or texture must pass its centre within {:g} pixel, and beyond it "
             "our own picture must take the other's value. Explaining is bounded: at most {:g} % "
             "of the edge pixels, at most {:g} % by edges that are off by more than {} pixel, no "
             "shift between the pictures, no common direction of the offsets. Everything else is "
             "unexplained, and fails; whether it is a coincident surface, a reference outlier or a "
             "known difference takes POV-Ray, and is not decidable from a picture. Of the pixels "
             "away from edges {:g} % must agree within {}.",
             shown(defaults.interior), defaults.radius, defaults.explained_share * 100,
             defaults.displaced_share * 100, shown(defaults.rounding), defaults.tight_share * 100,
             shown(defaults.tight))},
        {"Likely cause",
         "Where a picture differs it is tried whether one cause explains nearly all of it: the "
         "picture turned over or mirrored, a curve too many, another exposure, rays beside the "
         "pixels' centres, a light of another brightness or falloff, another up vector or angle of "
         "view, normals that point the other way, objects that are missing, terms of the materials "
         "that are left out or have another parameter, textures turned over, colours through a "
         "curve, another depth of recursion."},
    };
    return report;
}

}  // namespace lancer::judge
