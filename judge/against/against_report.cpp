#include <fmt/format.h>

#include "judge/against/against.h"
#include "judge/report/html.h"
#include "judge/validate/validation_text.h"

namespace lancer::judge {

namespace {

std::string encoding_words(const Encoding& encoding) {
    switch (encoding.kind) {
        case Encoding::Kind::automatic:
            return "by the curve that each file names (without one, whole numbers are sRGB, floats "
                   "are linear)";
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
        {"Programs",
         fmt::format(
             "Lancer {}, in double precision; the other pictures are files, made by any program.",
             lancer_version)},
        {"What is assumed",
         fmt::format(
             "Both pictures have one ray through each pixel, at ({:g}, {:g}) from its upper left "
             "corner; light in both is multiplied by {:g}; the depth of recursion is the scene's, "
             "the formulas are those of the shading page. The pictures were read {}. If none of a "
             "picture's values is above 1, ours are clipped at 1.",
             reading.center_x, reading.center_y, reading.exposure,
             encoding_words(reading.encoding))},
        {"Judgement",
         fmt::format(
             "A pixel in which a channel differs by more than {} must be explained: an edge of "
             "geometry, shadow or texture must pass within {:g} pixel of its centre, and beyond "
             "this edge our own picture must have the other picture's value. Explanations are "
             "limited: to at most {:g} % of the edge pixels, to at most {:g} % by edges that are "
             "off by more than {} pixel, and there must be no shift between the pictures and no "
             "common direction of the offsets. Everything else is unexplained, and fails; only "
             "POV-Ray can show whether it is a coincident surface, a reference outlier or a known "
             "difference, a picture alone cannot. Of the pixels away from edges {:g} % must agree "
             "within {}.",
             shown(defaults.interior), defaults.radius, defaults.explained_share * 100,
             defaults.displaced_share * 100, shown(defaults.rounding), defaults.tight_share * 100,
             shown(defaults.tight))},
        {"Likely cause",
         "Where a picture differs, Lancer tries whether one cause explains nearly all of it: the "
         "picture is upside down or mirrored, a curve was applied once too often, another "
         "exposure, rays that miss the pixels' centres, a light of another brightness or falloff, "
         "another up vector or angle of view, normals that point the other way, missing objects, "
         "terms of the materials that are left out or have another parameter, textures upside "
         "down, colours through a curve, another depth of recursion."},
    };
    return report;
}

}  // namespace lancer::judge
