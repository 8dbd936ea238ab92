#include "model/light.h"

#include "parser/blocks/blocks.h"
#include "parser/blocks/brightness.h"
#include "parser/rules.h"

namespace lancer::blocks {
namespace {

/// The fields of all three kinds of light. Each table names those that its kind has.
struct LightSpec {
    Vec3d position{0, 0, 0};
    Vec3d look_at{0, 0, 0};
    Vec3d direction{0, 0, 0};
    double radius = SpotLight{}.radius;
    double falloff = SpotLight{}.falloff;
    double tightness = 0;
    std::optional<double> fade_distance;
    double fade_power = Fade{}.power;
    Color color{1, 1, 1};
    bool shadows = true;
};

constexpr Field position =
    field<&LightSpec::position, rules::Vector>("position", required, "its position");
constexpr Field color =
    field<&LightSpec::color, rules::LightColor>("color", "[1, 1, 1]", "its colour and brightness");
constexpr Field shadows = field<&LightSpec::shadows, rules::Flag>(
    "shadows", "true", "false: a fill light, without shadows and highlights");
constexpr Field fade_distance = field<&LightSpec::fade_distance, rules::Positive>(
    "fade_distance", "none", "the distance at which fading leaves the light as it is");
constexpr Field fade_power = field<&LightSpec::fade_power, rules::NotNegative>(
    "fade_power", "2", "exponent of the distance in the fading");

constexpr Field point_fields[] = {position, color, fade_distance, fade_power, shadows};
constexpr Field directional_fields[] = {
    field<&LightSpec::direction, rules::Direction>("direction", required,
                                                   "direction in which its light travels"),
    color, shadows};
constexpr Field spot_fields[] = {
    position,
    field<&LightSpec::look_at, rules::Vector>("look_at", required,
                                              "the point in the middle of its cone"),
    color,
    field<&LightSpec::radius, rules::HalfAngle>("radius", "30",
                                                "half-angle of the fully lit cone, degrees"),
    field<&LightSpec::falloff, rules::HalfAngle>("falloff", "45",
                                                 "half-angle where the light ends, degrees"),
    field<&LightSpec::tightness, rules::NotNegative>(
        "tightness", "0", "exponent that concentrates the light on the axis"),
    fade_distance,
    fade_power,
    shadows};

std::optional<Fade> fade_of(const LightSpec& spec) {
    if (!spec.fade_distance) return std::nullopt;
    return Fade{*spec.fade_distance, spec.fade_power};
}

void add(BlockReader& block, const LightSpec& spec, const LightKind& kind) {
    // A light that fades may well be bright near its position.
    if (!spec.fade_distance) warn_bright_light(block.report(), block.place("color"), spec.color);
    block.builder().add(Light{kind, spec.color, spec.shadows, block.place()});
}

}  // namespace

const BlockInfo point_light{"light", "point", point_fields, {}, "shines from a point"};
const BlockInfo directional_light{
    "light", "directional", directional_fields, {}, "parallel light, the same everywhere"};
const BlockInfo spot_light{"light", "spot", spot_fields, {}, "shines from a point within a cone"};

void make_point_light(BlockReader& block, std::uint32_t&) {
    LightSpec spec;
    if (block.read(&spec)) add(block, spec, PointLight{spec.position, fade_of(spec)});
}

void make_directional_light(BlockReader& block, std::uint32_t&) {
    LightSpec spec;
    if (block.read(&spec)) add(block, spec, DirectionalLight{spec.direction});
}

void make_spot_light(BlockReader& block, std::uint32_t&) {
    LightSpec spec;
    block.read(&spec);
    if (block.has("position") && block.has("look_at") && block.good() &&
        spec.position == spec.look_at)
        block.error(Message::spot_without_direction, block.place("look_at"));
    if (block.good() && spec.falloff < spec.radius)
        block.error(Message::falloff_below_radius,
                    block.place(block.has("falloff") ? "falloff" : "radius"), to_text(spec.falloff),
                    to_text(spec.radius));
    if (!block.good()) return;
    add(block, spec,
        SpotLight{spec.position, spec.look_at, spec.radius, spec.falloff, spec.tightness,
                  fade_of(spec)});
}

}  // namespace lancer::blocks
