// lancer probe
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/ray_tree_json.h"
#include "cli/ray_tree_text.h"
#include "cli/scene_loader.h"
#include "cli/settings_options.h"
#include "model/io/quantize.h"
#include "tracer/ray_tree_renderer.h"

namespace lancer::cli {
namespace {

/// Column and row, counted from 0 at the top left corner.
struct Pixel {
    int x = 0;
    int y = 0;
};

Pixel parse_pixel(const std::string& text) {
    const std::size_t comma = text.find(',');
    const auto read = [&](std::size_t begin, std::size_t end) {
        int value = -1;
        const char* last = text.data() + end;
        const auto [rest, error] = std::from_chars(text.data() + begin, last, value);
        return error == std::errc() && rest == last ? value : -1;
    };
    Pixel pixel{-1, -1};
    if (comma != std::string::npos) pixel = {read(0, comma), read(comma + 1, text.size())};
    if (pixel.x < 0 || pixel.y < 0)
        throw UsageError(fmt::format(
            "'{}' is not a pixel: expected X,Y from the top left corner, as in 120,60", text));
    return pixel;
}

void check_pixel(const Pixel& pixel, const View& view) {
    if (pixel.x < view.width && pixel.y < view.height) return;
    throw UsageError(
        fmt::format("pixel {},{} is outside of the picture of {}x{}: the last is {},{}", pixel.x,
                    pixel.y, view.width, view.height, view.width - 1, view.height - 1));
}

struct ProbeJob {
    std::string scene;
    Pixel pixel;
    std::string camera;
    std::string json;
    std::optional<PictureSize> size;
    std::optional<std::int64_t> sample;
    SettingsOptions settings;
    SceneOptions scene_options;
};

/// The result of the command.
struct Found {
    View view;
    std::string camera;
    Color pixel;          ///< the picture's value: the mean over the pixel's rays
    std::size_t samples;  ///< rays of the pixel
    std::size_t sample;   ///< the index of the traced ray
    PicturePoint at;      ///< the point of the picture that it passes
    RayTree tree;
};

/// The index of the ray nearest to the pixel's centre; the first one among equals.
std::size_t middle_of(const std::vector<PicturePoint>& points, const Pixel& pixel) {
    const auto distance = [&](const PicturePoint& p) {
        return std::hypot(p.x - pixel.x - 0.5, p.y - pixel.y - 0.5);
    };
    const auto nearest = std::min_element(
        points.begin(), points.end(),
        [&](const PicturePoint& a, const PicturePoint& b) { return distance(a) < distance(b); });
    return static_cast<std::size_t>(nearest - points.begin());
}

std::string light_text(const Color& c) {
    const io::Quantizer to_bytes(8, false);
    return fmt::format("[{:.6g}, {:.6g}, {:.6g}], in 8 bits {} {} {}", c.x, c.y, c.z,
                       to_bytes.encoded(c.x), to_bytes.encoded(c.y), to_bytes.encoded(c.z));
}

std::string to_text(const ProbeJob& job, const Found& found, const Scene& scene,
                    const SourceMap& sources) {
    std::string out =
        fmt::format("pixel {},{} of {}x{}{}: {}\n", job.pixel.x, job.pixel.y, found.view.width,
                    found.view.height, found.camera.empty() ? "" : ", camera " + found.camera,
                    light_text(found.pixel));
    if (found.samples > 1)
        out += fmt::format("ray {} of the {} whose mean it is: {}\n", found.sample + 1,
                           found.samples, light_text(found.tree.color));
    out += fmt::format("through {:.9g},{:.9g} of the picture\n\n", found.at.x, found.at.y);
    return out + ray_tree_text(found.tree, scene, sources);
}

std::string to_json(const ProbeJob& job, const Found& found, const Scene& scene,
                    const SourceMap& sources) {
    nlohmann::ordered_json json;
    json["scene"] = job.scene;
    json["camera"] = found.camera;
    json["picture"] = {{"width", found.view.width}, {"height", found.view.height}};
    json["pixel"] = {{"x", job.pixel.x}, {"y", job.pixel.y}, {"color", vector_json(found.pixel)}};
    json["sample"] = {{"number", found.sample + 1},
                      {"of", found.samples},
                      {"x", found.at.x},
                      {"y", found.at.y},
                      {"color", vector_json(found.tree.color)}};
    json["settings"] = {{"max_depth", scene.settings.max_depth},
                        {"min_contribution", scene.settings.min_contribution}};
    json["is_cut"] = found.tree.is_cut;
    json["rays"] = ray_tree_json(found.tree, scene, sources);
    // Names in a scene may come from the command line, so they need not be UTF-8.
    return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

Found find(const ProbeJob& job, Scene& scene, const Session& session) {
    Found found;
    found.view.camera = pick_camera(scene, job.camera, session);
    found.view.width = job.size ? job.size->width : scene.width;
    found.view.height = job.size ? job.size->height : scene.height;
    check_pixel(job.pixel, found.view);
    found.camera = scene.cameras[found.view.camera].name;
    job.settings.apply_to(scene.settings);
    const auto renderer = compile_for_ray_trees(scene, scene.settings);
    const std::vector<PicturePoint> points = renderer->samples(job.pixel.x, job.pixel.y);
    found.samples = points.size();
    if (job.sample && static_cast<std::size_t>(*job.sample) > points.size())
        throw UsageError(fmt::format("--sample {}: the pixel has {} ray{}", *job.sample,
                                     points.size(), points.size() == 1 ? "" : "s"));
    found.sample =
        job.sample ? static_cast<std::size_t>(*job.sample - 1) : middle_of(points, job.pixel);
    found.at = points[found.sample];
    View one = found.view;
    one.crop = Crop{job.pixel.x, job.pixel.y, 1, 1};
    RayCounts ignored;
    const Image image = renderer->render(one, {}, ignored);
    found.pixel = {image.pixel(0, 0)[0], image.pixel(0, 0)[1], image.pixel(0, 0)[2]};
    found.tree = renderer->ray_tree(found.view, found.at);
    return found;
}

ExitCode probe(const ProbeJob& job, Session& session) {
    session.will_write(job.json, "--json");
    SceneLoader loader(job.scene, job.scene_options, session, job.settings.reading_threads());
    Scene scene = loader.load(0, 0);
    session.terminal.show(missing_parts(scene), session.sources);
    const Found found = find(job, scene, session);
    if (job.json.empty())
        session.output.put(to_text(job, found, scene, session.sources));
    else
        session.write(job.json, to_json(job, found, scene, session.sources));
    return ExitCode::done;
}

}  // namespace

void add_probe(CLI::App& app, Action& action) {
    CLI::App& command = *app.add_subcommand(
        "probe", "Explain why a pixel has its colour: everything that its ray does");
    const auto job = std::make_shared<ProbeJob>();
    command.add_option("SCENE", job->scene, "Scene file; - reads standard input")
        ->required()
        ->type_name("");
    command
        .add_option_function<std::string>(
            "PIXEL", [job = job.get()](const std::string& text) { job->pixel = parse_pixel(text); },
            "X,Y from the picture's top left corner, as in 120,60; 0,0 is the first")
        ->required()
        ->type_name("");
    command.add_option("--json", job->json, "Write JSON; - to standard output")->type_name("FILE");
    command.add_option("--camera", job->camera, "Name of the camera; by default the first one")
        ->type_name("NAME");
    command
        .add_option_function<std::string>(
            "--size", [job = job.get()](const std::string& text) { job->size = parse_size(text); },
            "Size of the picture in pixels")
        ->type_name("WxH");
    add_whole_number(command, "--sample", job->sample, 1, 1'000'000'000,
                     "Which of the pixel's rays, in the order in which they are summed; by default "
                     "the one nearest to its centre")
        ->type_name("K");
    add_settings_options(command, job->settings);
    add_scene_options(command, job->scene_options);
    command.footer(
        "Examples:"
        "\n  lancer probe scene.lancer 120,60");
    command.callback(
        [&action, job] { action = [job](Session& session) { return probe(*job, session); }; });
}

}  // namespace lancer::cli
