// image, render, camera, background and ambient.
#include <limits>

#include "model/quality.h"
#include "model/scene.h"
#include "parser/blocks/blocks.h"
#include "parser/evaluation/singles.h"
#include "parser/rules.h"

namespace lancer {
namespace rules {

enum class ProjectionKind { perspective, orthographic };

template <>
struct Words<ProjectionKind> {
    static constexpr std::string_view takes = "perspective or orthographic";
    static constexpr std::array<std::string_view, 2> words{"perspective", "orthographic"};
    static constexpr std::array values{ProjectionKind::perspective, ProjectionKind::orthographic};
};

template <>
struct Words<Sampling> {
    static constexpr std::string_view takes = "grid or sobol";
    static constexpr std::array<std::string_view, 2> words{"grid", "sobol"};
    static constexpr std::array values{Sampling::grid, Sampling::sobol};
};

template <>
struct Words<Quality> {
    static constexpr std::string_view takes = "draft, normal, fine or exact";
    static constexpr std::array<std::string_view, 4> words{"draft", "normal", "fine", "exact"};
    static constexpr std::array values = all_qualities;
};

}  // namespace rules

namespace blocks {
namespace {

struct ImageSize {
    int width = 640;
    int height = 480;
};

struct QualityChoice {
    Quality quality = Quality::normal;
};

struct CameraSpec {
    Vec3d position{0, 0, 0};
    Vec3d look_at{0, 0, 0};
    Vec3d up{0, 1, 0};
    rules::ProjectionKind projection = rules::ProjectionKind::perspective;
    double fov = PerspectiveProjection{}.fov;
    double height = 0;
};

constexpr Field file_fields[] = {
    field<&Scene::background, rules::ColorRule>("background", "[0, 0, 0]",
                                                "colour of rays that hit nothing"),
    field<&Scene::ambient, rules::ColorRule>("ambient", "[1, 1, 1]", "light from all directions"),
};
constexpr Field image_fields[] = {
    field<&ImageSize::width, rules::PixelCount>("width", "640", "pixels"),
    field<&ImageSize::height, rules::PixelCount>("height", "480", "pixels"),
};
constexpr Field render_fields[] = {
    field<&Settings::max_depth, rules::Depth>("max_depth", "8",
                                              "levels of recursion; 1: primary rays only"),
    field<&Settings::min_contribution, rules::NotNegative>(
        "min_contribution", "0.002", "rays of less weight are not followed; 0: all are followed"),
    field<&Settings::samples, rules::Depth>("samples", "1",
                                            "n: n x n rays per pixel; 1: through its centre"),
    field<&Settings::sampling, rules::WordRule<Sampling>>(
        "sampling", "grid",
        "where these rays pass through the pixel: a regular grid, or Sobol points"),
    field<&Settings::shadows, rules::Flag>("shadows", "true", "false: objects block no light"),
    field<&Settings::smooth, rules::Flag>("smooth", "true",
                                          "false: no interpolated normals, faster"),
    field<&Settings::textures, rules::Flag>("textures", "true",
                                            "false: plain colours instead of textures"),
    field<&Settings::tolerance, rules::Positive>(
        "tolerance", "true surfaces",
        "largest distance of a tessellated surface from the true one"),
};
constexpr Field quality_fields[] = {
    field<&QualityChoice::quality, rules::WordRule<Quality>>(
        "quality", "none", "sets max_depth, min_contribution, samples and sampling together"),
};
constexpr Field camera_fields[] = {
    field<&CameraSpec::position, rules::Vector>("position", required, "its position"),
    field<&CameraSpec::look_at, rules::Vector>("look_at", required,
                                               "the point in the middle of the picture"),
    field<&CameraSpec::up, rules::Direction>("up", "[0, 1, 0]",
                                             "direction that is up in the picture"),
    field<&CameraSpec::fov, rules::FieldOfView>("fov", "40",
                                                "full vertical angle of view, degrees"),
    field<&CameraSpec::projection, rules::WordRule<rules::ProjectionKind>>(
        "projection", "perspective", "or orthographic, for parallel rays"),
    field<&CameraSpec::height, rules::Positive>(
        "height", "none", "height of an orthographic picture, in scene units"),
};

using Extended = Vec3<long double>;

/// True when the vectors are parallel within rounding: the cross product is compared with the
/// rounding error relative to the lengths.
bool are_parallel(const Vec3d& a, const Extended& b) {
    const Extended x = convert<long double>(a);
    constexpr long double rounding = 4 * std::numeric_limits<double>::epsilon();
    return length(cross(x, b)) <= rounding * length(x) * length(b);
}

/// Warns about a camera with a very narrow view that is not far away: its angle was probably given
/// in radians.
void warn_of_radians(BlockReader& block, double fov, double distance) {
    constexpr double least = 0.2;
    constexpr double most = 2.1;
    constexpr double far = 100;
    if (fov < least || fov > most || distance > far) return;
    Diagnostic* warning =
        block.report().warning(Message::fov_of_radians, block.place("fov"), to_text(fov));
    if (warning != nullptr)
        warning->hint =
            fmt::format("fov is in degrees: if {} is meant in radians, write fov {:.0f}",
                        to_text(fov), fov * 180 / 3.141592653589793);
}

}  // namespace

const BlockInfo file{"", "", file_fields, {}, "properties at file level"};
const BlockInfo image{"image", "", image_fields, {}, "size of the picture"};
const BlockInfo render{"render", "", render_fields, quality_fields,
                       "how to render; options on the command line take precedence"};
const BlockInfo camera{
    "camera", "", camera_fields, {}, "a point of view; the first is the default"};

void make_image(BlockReader& block, std::uint32_t&) {
    if (block.context().singles.is_second_image(block.place())) return;
    ImageSize size;
    if (!block.read(&size)) return;
    block.builder().scene.width = size.width;
    block.builder().scene.height = size.height;
}

void make_render(BlockReader& block, std::uint32_t&) {
    if (block.context().singles.is_second_render(block.place())) return;
    Settings& settings = block.builder().scene.settings;
    QualityChoice choice;
    if (!block.read(&settings, &choice) || !block.has("quality")) return;
    // Values that the script gives override the preset.
    const Settings written = settings;
    apply(values_of(choice.quality), settings);
    if (block.has("max_depth")) settings.max_depth = written.max_depth;
    if (block.has("min_contribution")) settings.min_contribution = written.min_contribution;
    if (block.has("samples")) settings.samples = written.samples;
    if (block.has("sampling")) settings.sampling = written.sampling;
}

void make_camera(BlockReader& block, std::uint32_t&) {
    CameraSpec spec;
    block.read(&spec);
    const bool orthographic = spec.projection == rules::ProjectionKind::orthographic;
    if (orthographic && block.has("fov"))
        block.error(Message::fov_of_orthographic, block.place("fov"));
    if (!orthographic && block.has("height"))
        block.error(Message::height_of_perspective, block.place("height"));
    if (orthographic && !block.has("height") && block.good())
        block.error(Message::height_missing, block.place());
    if (!block.context().singles.is_new_camera(std::string(block.name()), block.name_place()) ||
        !block.good())
        return;
    const Extended view = convert<long double>(spec.look_at) - convert<long double>(spec.position);
    if (view == Extended(0, 0, 0)) {
        block.error(Message::look_at_is_position, block.place("look_at"));
    } else if (are_parallel(spec.up, view)) {
        Diagnostic* error = block.error(
            Message::up_along_view, block.has("up") ? block.place("up") : block.place("look_at"));
        if (error != nullptr && !block.has("up"))
            error->hint = "up is [0, 1, 0] unless it is given";
    }
    if (!block.good()) return;
    Camera made;
    made.name = block.name();
    made.position = spec.position;
    made.look_at = spec.look_at;
    made.up = spec.up;
    if (orthographic) {
        made.projection = OrthographicProjection{spec.height};
    } else {
        made.projection = PerspectiveProjection{spec.fov};
        if (block.has("fov"))
            warn_of_radians(block, spec.fov, length(spec.look_at - spec.position));
    }
    made.place = block.place();
    block.builder().add(made);
}

}  // namespace blocks
}  // namespace lancer
