#include "reference/pov/export.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>

#include "reference/pov/choices.h"
#include "reference/pov/coincidence.h"
#include "reference/pov/composites.h"
#include "reference/pov/declaration_order.h"
#include "reference/pov/differences.h"
#include "reference/pov/export_scale.h"
#include "reference/pov/glued_bodies.h"
#include "reference/pov/resolution.h"
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

namespace {

PowerOfTen scale_for(const Scene& scene, const ExportView& view, const ExportOptions& options) {
    if (options.decades) return {*options.decades};
    if (options.resolve_coincidences) return largest_scale(scene, view);
    return export_scale(scene, view, options.keep_lengths);
}

/// The step of a resolution, in units of the scene: several times POV-Ray's least distance of a
/// shadow. It is also more than the single-precision error of a bounding box, beyond which POV-Ray
/// does not search.
double resolving_step(const Scene& scene, const std::vector<FacePair>& pairs, PowerOfTen scale) {
    double farthest = 0;
    for (const FacePair& pair : pairs) {
        for (const Face& face : {pair.front, pair.back}) {
            const Object& object = part_of(scene, face.object, face.part);
            const auto own = shape_bounds(scene, object.shape);
            if (!own) continue;
            const Bounds bounds = moved(scene.transforms[object.transform], *own);
            for (int axis = 0; axis < 3; ++axis)
                farthest =
                    std::max({farthest, std::abs(bounds.low[axis]), std::abs(bounds.high[axis])});
        }
    }
    return std::max(scale.inverse()(resolving_step_length), 1e-6 * farthest);
}

void write_objects(Writer& writer) {
    std::map<std::uint32_t, const std::vector<std::uint32_t>*> groups;
    for (const auto& group : writer.merged)
        for (const std::uint32_t member : group) groups.emplace(member, &group);
    for (const std::uint32_t i : declaration_order(writer.scene, writer.view)) {
        const auto found = groups.find(i);
        if (found == groups.end())
            write_object(writer, i);
        else if (found->second->front() == i)
            write_merged(writer, *found->second);
    }
}

}  // namespace

}  // namespace pov

std::string resolution_name(Coincidence::Resolution resolution) {
    switch (resolution) {
        case Coincidence::Resolution::hidden:
            return "hidden";
        case Coincidence::Resolution::sunk:
            return "sunk into the opaque one";
        case Coincidence::Resolution::merged:
            return "glued to one body";
        case Coincidence::Resolution::overlapped:
            return "overlapping";
        case Coincidence::Resolution::in_front:
            return "one in front of the other";
        case Coincidence::Resolution::none:
            return "unresolved";
    }
    return "";
}

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
    const pov::PowerOfTen scale = pov::scale_for(scene, view, options);
    const std::vector<pov::FacePair> pairs = pov::face_pairs(scene);
    pov::ResolvedScene shown{scene, {}, pairs};
    if (!pairs.empty())
        shown = pov::resolved(scene, pairs, pov::resolving_step(scene, pairs, scale));
    result.coincidences = pov::coincidences(shown.pairs);
    if (!options.resolve_coincidences) shown = {scene, {}, {}};
    if (options.resolve_coincidences)
        result.resolved = std::make_shared<Scene>(pov::with_unions(shown.scene, shown.merged));
    pov::Writer writer{shown.scene, view, options, result, scale, {}, {}, {}, {}, shown.merged};
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
    pov::write_objects(writer);

    result.known_differences = pov::known_differences(scene, scale, result.coincidences);
    if (result.refusals.empty())
        result.text = writer.text.take();
    else
        result.assets.clear();
    return result;
}

}  // namespace lancer::reference
