// Settings, camera, lights.
#include <fmt/format.h>

#include <algorithm>

#include "reference/pov/choices.h"
#include "reference/pov/writer.h"

namespace lancer::reference::pov {

namespace {

/// POV-Ray's gradient runs from 0 to 1 along its axis, while a coordinate of a direction runs from
/// -1 to 1. The gradient is placed between a quarter and three quarters, where nothing repeats.
void write_sky(Writer& writer, const Gradient& sky) {
    if (sky.stops.size() > 256)
        writer.refuse({}, "POV-Ray's colour maps hold at most 256 stops, and the sky has more");
    Text& text = writer.text;
    const Vec3d axis = normalize(sky.axis / max_component(absolute(sky.axis)));
    text.open("sky_sphere {");
    text.open("pigment {");
    text.line("gradient " + vector(axis));
    text.open("color_map {");
    for (const Gradient::Stop& stop : sky.stops)
        text.line("[" + number((stop.at + 2) / 4) + " " + rgb(writer.lit(stop.color)) + "]");
    text.close();
    text.line("scale 4 translate " + vector(-2.0 * axis));
    text.close();
    text.close();
}

}  // namespace

void write_global_settings(Writer& writer) {
    const Scene& scene = writer.scene;
    Text& text = writer.text;
    text.line("#version 3.7;");
    text.open("global_settings {");
    text.line("assumed_gamma 1.0");
    text.line(fmt::format("max_trace_level {}", std::min(scene.settings.max_depth, most_levels)));
    text.line("adc_bailout " + number(scene.settings.min_contribution));
    text.line("ambient_light " + rgb(writer.lit(scene.ambient)));
    text.close();
    text.line("background { " + rgb(writer.lit(scene.background)) + " }");
    if (scene.sky) write_sky(writer, *scene.sky);
}

void write_camera(Writer& writer) {
    const Camera& camera = writer.scene.cameras[writer.view.camera];
    const Vec3d forward = normalize(camera.look_at - camera.position);
    const Vec3d right = normalize(cross(forward, camera.up));
    const Vec3d up = cross(right, forward);
    const double aspect =
        static_cast<double>(writer.view.width) / static_cast<double>(writer.view.height);
    Text& text = writer.text;
    text.open("camera {" + (camera.name.empty() ? "" : "  // " + comment(camera.name)));
    double height{};
    if (const auto* perspective = std::get_if<PerspectiveProjection>(&camera.projection)) {
        text.line("perspective  // vertical angle " + number(perspective->fov));
        height = 2 * elementary::tan(radians(perspective->fov / 2));
    } else {
        text.line("orthographic");
        height = writer.scale(std::get<OrthographicProjection>(camera.projection).height);
    }
    Vec3d across = right * (height * aspect);
    Vec3d upright = up * height;
    Vec3d location = writer.scale(camera.position);
    Vec3d direction = forward;
    if (const auto& close = writer.options.close_up) {
        const double x = close->x / writer.view.width - 0.5;
        const double y = 0.5 - close->y / writer.view.height;
        const bool perspective = std::holds_alternative<PerspectiveProjection>(camera.projection);
        (perspective ? direction : location) += x * across + y * upright;
        across *= close->pitch * CloseUp::points / writer.view.width;
        upright *= close->pitch * CloseUp::points / writer.view.height;
    }
    text.line("location " + vector(location));
    text.line("direction " + vector(direction));
    // POV-Ray is left-handed. A picture of our right-handed scene needs the right vector mirrored
    // against POV-Ray's default; a right-handed cross product gives this vector.
    text.line("right " + vector(across));
    text.line("up " + vector(upright));
    text.close();
}

namespace {

void write_fade(Writer& writer, const std::optional<Fade>& fade) {
    if (!fade) return;
    writer.text.line("fade_distance " + number(writer.scale(fade->distance)) + " fade_power " +
                     number(fade->power));
}

struct LightWriter {
    Writer& writer;

    void operator()(const PointLight& light) const {
        writer.text.line(vector(writer.scale(light.position)) + ", " + color);
        write_fade(writer, light.fade);
    }
    void operator()(const SpotLight& light) const {
        writer.text.line(vector(writer.scale(light.position)) + ", " + color);
        writer.text.line("spotlight point_at " + vector(writer.scale(light.look_at)));
        writer.text.line("radius " + number(light.radius) + " falloff " + number(light.falloff) +
                         " tightness " + number(light.tightness));
        write_fade(writer, light.fade);
    }
    void operator()(const DirectionalLight& light) const {
        // POV-Ray lights what lies behind the plane of a parallel light without shadow. So the
        // light stands as far away as POV-Ray can see: half of its limit of 1e7.
        writer.text.line(vector(-normalize(light.direction) * far_away) + ", " + color);
        writer.text.line("parallel point_at " + vector(Vec3d{}));
    }
    std::string color;
};

}  // namespace

void write_light(Writer& writer, const Light& light) {
    // In POV-Ray, `spotlight` and `shadowless` are two values of one setting, and the later word
    // wins.
    if (!light.shadows && std::holds_alternative<SpotLight>(light.kind))
        writer.refuse(light.place, "POV-Ray's lights without shadows have no cone",
                      "give the spot light shadows, or use a point light");
    writer.text.open("light_source {");
    std::visit(LightWriter{writer, rgb(writer.lit(light.color))}, light.kind);
    if (!light.shadows) writer.text.line("shadowless");
    writer.text.close();
}

}  // namespace lancer::reference::pov
