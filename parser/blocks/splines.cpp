// patch, lathe, prism.
#include "model/splines.h"

#include <fmt/format.h>

#include <algorithm>

#include "parser/blocks/attributes.h"
#include "parser/blocks/blocks.h"

namespace lancer {
namespace rules {

template <>
struct Words<Spline> {
    static constexpr std::string_view takes = "one of linear, bezier, bspline, catmull_rom";
    static constexpr std::array<std::string_view, 4> words{"linear", "bezier", "bspline",
                                                           "catmull_rom"};
    static constexpr std::array values{Spline::linear, Spline::bezier, Spline::bspline,
                                       Spline::catmull_rom};
};
template <>
struct Words<Patch::Basis> {
    static constexpr std::string_view takes = "bezier or bspline";
    static constexpr std::array<std::string_view, 2> words{"bezier", "bspline"};
    static constexpr std::array values{Patch::Basis::bezier, Patch::Basis::bspline};
};

}  // namespace rules

namespace blocks {
namespace {

struct PatchSpec {
    std::vector<std::vector<Vec3d>> control;
    Patch::Basis basis = Patch::Basis::bezier;
    std::optional<double> tolerance;
};

constexpr std::string_view tolerance_doc =
    "largest distance of a tessellation from the true surface, in scene units";
constexpr std::string_view tolerance_standard = "render's";

constexpr Field patch_fields[] = {
    field<&PatchSpec::control, rules::Net>("control", required, "rows of control points"),
    field<&PatchSpec::basis, rules::WordRule<Patch::Basis>>(
        "basis", "bezier", "bezier: 4 x 4 points; bspline: 4 x 4 or more"),
    field<&PatchSpec::tolerance, rules::Positive>("tolerance", tolerance_standard, tolerance_doc),
};
constexpr Field lathe_fields[] = {
    field<&Lathe::profile, rules::PlanePoints>(
        "profile", required, "points [radius, y] of the curve that is turned round the y axis"),
    field<&Lathe::spline, rules::WordRule<Spline>>("spline", "linear",
                                                   "how the points define the curve"),
    field<&Lathe::tolerance, rules::Positive>("tolerance", tolerance_standard, tolerance_doc),
};
constexpr Field prism_fields[] = {
    field<&Prism::outline, rules::PlanePoints>("outline", required,
                                               "points [x, z] of the closed curve"),
    field<&Prism::spline, rules::WordRule<Spline>>("spline", "linear",
                                                   "how the points define the curve"),
    field<&Prism::bottom, rules::Number>("bottom", required, "least y"),
    field<&Prism::top, rules::Number>("top", required, "greatest y"),
    field<&Prism::capped, rules::Flag>("capped", "true", "false: only the side, without caps"),
    field<&Prism::tolerance, rules::Positive>("tolerance", tolerance_standard, tolerance_doc),
};

std::string count_of(std::size_t count) {
    return std::to_string(count) + (count == 1 ? " point" : " points");
}

std::string_view word_of(Spline spline) {
    return rules::Words<Spline>::words[static_cast<std::size_t>(spline)];
}

std::string_view profile_counts(Spline spline) {
    switch (spline) {
        case Spline::linear:
            return "2 or more";
        case Spline::bezier:
            return "4, 7, 10, ... (3n + 1)";
        default:
            return "4 or more";
    }
}

std::string_view outline_counts(Spline spline) {
    return spline == Spline::bezier ? "3, 6, 9, ... (3n)" : "3 or more";
}

/// Whether the last point repeats the first one. A Bézier outline has 3n points, and the last of
/// these is a control point of the closing side, which may lie on the first point. So only one more
/// point, number 3n + 1, can be a repetition.
bool repeats_first_point(Spline spline, const std::vector<Vec2d>& outline) {
    return outline.size() > 1 && outline.front() == outline.back() && !is_single_point(outline) &&
           (spline != Spline::bezier || outline.size() % 3 == 1);
}

void check_net(BlockReader& block, const PatchSpec& spec) {
    const std::size_t rows = spec.control.size();
    const std::size_t columns = rows == 0 ? 0 : spec.control.front().size();
    for (std::size_t i = 1; i < rows; ++i) {
        if (spec.control[i].size() == columns) continue;
        block.error(Message::net_ragged, block.place("control"), i + 1,
                    count_of(spec.control[i].size()), columns);
        return;
    }
    if (spec.basis == Patch::Basis::bezier && (rows != 4 || columns != 4)) {
        block.error(Message::net_bezier, block.place("control"), rows, columns);
    } else if (rows < 4 || columns < 4) {
        block.error(Message::net_bspline, block.place("control"), rows, columns);
    }
}

}  // namespace

const BlockInfo patch{"patch", "", patch_fields, attribute_fields, "a curved surface"};
const BlockInfo lathe{"lathe", "", lathe_fields, attribute_fields,
                      "a curve turned round the y axis"};
const BlockInfo prism{"prism", "", prism_fields, attribute_fields,
                      "a closed curve extruded along y"};

void make_patch(BlockReader& block, std::uint32_t&) {
    PatchSpec spec;
    Attributes attributes;
    if (!block.read(&spec, &attributes)) return;
    check_net(block, spec);
    if (!block.good()) return;
    Patch made;
    made.basis = spec.basis;
    made.rows = static_cast<std::uint32_t>(spec.control.size());
    made.columns = static_cast<std::uint32_t>(spec.control.front().size());
    made.tolerance = spec.tolerance;
    block.meter().elements(std::uint64_t{made.rows} * made.columns, block.place("control"));
    for (const auto& row : spec.control)
        made.control.insert(made.control.end(), row.begin(), row.end());
    if (is_single_point(made.control)) {
        block.warning(Message::all_points_equal, block.place(), "patch");
        return;
    }
    auto& all = block.builder().scene.patches;
    all.push_back(std::move(made));
    block.builder().add(PatchRef{static_cast<std::uint32_t>(all.size() - 1)}, attributes,
                        block.place());
}

void make_lathe(BlockReader& block, std::uint32_t&) {
    Lathe made;
    Attributes attributes;
    if (!block.read(&made, &attributes)) return;
    if (!is_profile_count(made.spline, made.profile.size())) {
        block.error(Message::profile_count, block.place("profile"), word_of(made.spline),
                    profile_counts(made.spline), count_of(made.profile.size()));
        return;
    }
    if (is_single_point(made.profile)) {
        block.warning(Message::all_points_equal, block.place(), "lathe");
        return;
    }
    if (const auto bad = negative_radius(profile_curve(made.spline, made.profile))) {
        const bool has_negative =
            std::ranges::any_of(made.profile, [](const Vec2d& p) { return p.x < 0; });
        block.error(has_negative ? Message::profile_negative : Message::profile_swings,
                    block.place("profile"), fmt::format("{:.3g}", bad->point.y));
        return;
    }
    auto& all = block.builder().scene.lathes;
    all.push_back(std::move(made));
    block.builder().add(LatheRef{static_cast<std::uint32_t>(all.size() - 1)}, attributes,
                        block.place());
}

void make_prism(BlockReader& block, std::uint32_t&) {
    Prism made;
    Attributes attributes;
    block.read(&made, &attributes);
    if (block.has("top") && block.has("bottom") && block.good() && !(made.top > made.bottom))
        block.error(Message::prism_upside_down, block.place("top"));
    if (!block.good()) return;
    auto& outline = made.outline;
    const bool repeated = repeats_first_point(made.spline, outline);
    if (repeated) outline.pop_back();
    if (!is_outline_count(made.spline, outline.size())) {
        block.error(Message::outline_count, block.place("outline"), word_of(made.spline),
                    outline_counts(made.spline),
                    count_of(outline.size()) + (repeated ? " and the first again" : ""));
        return;
    }
    if (is_single_point(outline)) {
        block.warning(Message::all_points_equal, block.place(), "prism");
        return;
    }
    if (const auto at = self_crossing(outline_curve(made.spline, outline))) {
        block.error(Message::outline_crosses, block.place("outline"), fmt::format("{:.3g}", at->x),
                    fmt::format("{:.3g}", at->y));
        return;
    }
    auto& all = block.builder().scene.prisms;
    all.push_back(std::move(made));
    block.builder().add(PrismRef{static_cast<std::uint32_t>(all.size() - 1)}, attributes,
                        block.place());
}

}  // namespace blocks
}  // namespace lancer
