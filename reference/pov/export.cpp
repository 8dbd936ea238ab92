#include "reference/pov/export.h"

#include <cassert>

#include "reference/pov/declaration_order.h"
#include "reference/pov/differences.h"
#include "reference/pov/export_scale.h"
#include "reference/pov/writer.h"

namespace lancer::reference {

namespace pov {

void Writer::refuse(const SourceSpan& where, const std::string& message, const std::string& hint) {
    Diagnostic diagnostic;
    diagnostic.where = where;
    diagnostic.message = "cannot be exported: " + message;
    diagnostic.hint = hint;
    result.refusals.push_back(diagnostic);
}

void Writer::approximate(const SourceSpan& where, const std::string& explanation) {
    result.approximations.push_back({explanation, where});
}

}  // namespace pov

std::string rule_name(KnownDifference::Rule rule) {
    switch (rule) {
        case KnownDifference::Rule::absorption_inside:
            return "absorption-inside";
        case KnownDifference::Rule::absorption_nested:
            return "absorption-nested";
        case KnownDifference::Rule::absorption_smooth:
            return "absorption-smooth";
        case KnownDifference::Rule::fresnel_nested:
            return "fresnel-nested";
        case KnownDifference::Rule::sheet_in_medium:
            return "sheet-in-medium";
        case KnownDifference::Rule::contribution:
            return "contribution";
        case KnownDifference::Rule::depth_limit:
            return "depth-limit";
        case KnownDifference::Rule::small_features:
            return "small-features";
        case KnownDifference::Rule::far_away:
            return "far-away";
        case KnownDifference::Rule::coincident_surfaces:
            return "coincident-surfaces";
        case KnownDifference::Rule::light_from_behind:
            return "light-from-behind";
        case KnownDifference::Rule::patch_facets:
            return "patch-facets";
        case KnownDifference::Rule::index_single:
            return "index-single";
    }
    return "";
}

ExportResult export_pov(const Scene& scene, const ExportView& view, const ExportOptions& options) {
    assert(view.camera < scene.cameras.size() && view.width > 0 && view.height > 0);
    ExportResult result;
    const pov::PowerOfTen scale = options.decades
                                      ? pov::PowerOfTen{*options.decades}
                                      : pov::export_scale(scene, view, options.keep_lengths);
    pov::Writer writer{scene, view, options, result, scale, {}, {}, {}, {}};
    result.factor = scale.factor();
    result.decades = scale.exponent;
    result.unit = scale.inverse().factor();
    result.patch_halvings.resize(scene.patches.size());
    result.exposure = options.exposure;

    write_header(writer);
    write_global_settings(writer);
    write_camera(writer);
    for (const Light& light : scene.lights) write_light(writer, light);
    writer.text.blank();
    declare_textures(writer);
    writer.text.blank();
    for (const std::uint32_t i : pov::declaration_order(scene, view)) write_object(writer, i);

    result.known_differences = pov::known_differences(scene, scale);
    if (result.refusals.empty())
        result.text = writer.text.take();
    else
        result.assets.clear();
    return result;
}

}  // namespace lancer::reference
