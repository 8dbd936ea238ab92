// lancer info
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/scene_loader.h"
#include "cli/scene_summary.h"
#include "cli/stopwatch.h"
#include "model/diagnostic.h"
#include "tracer/render.h"
#include "tracer/wide/level.h"

namespace lancer::cli {
namespace {

struct InfoJob {
    std::string scene;
    bool json = false;
    SceneOptions scene_options;
};

/// `3 spheres, 1 box`
std::string list_of(const std::vector<Count>& counts) {
    std::string text;
    for (const auto& [kind, number] : counts) {
        const char* plural = number == 1                                  ? ""
                             : kind.ends_with('x') || kind.ends_with('h') ? "es"
                                                                          : "s";
        text += fmt::format("{}{} {}{}", text.empty() ? "" : ", ", number, kind, plural);
    }
    return text.empty() ? "none" : text;
}

std::string projection_of(const Camera& camera) {
    if (const auto* p = std::get_if<PerspectiveProjection>(&camera.projection))
        return fmt::format("perspective, {} degrees", p->fov);
    return fmt::format("orthographic, {} high",
                       std::get<OrthographicProjection>(camera.projection).height);
}

/// The cost in seconds before the first ray. Each part of a picture repeats it.
struct FixedCost {
    double parse = 0;
    double evaluate = 0;
    double build = 0;
    std::string failure;  ///< why nothing can be built
};

FixedCost cost_of(const SceneLoader& loader, const Scene& scene) {
    FixedCost cost{loader.parse_seconds(), loader.evaluate_seconds(), 0, ""};
    const Stopwatch watch;
    try {
        compile(scene, scene.settings, best_level());
    } catch (const SceneError& error) {
        cost.failure = error.what();
    }
    cost.build = watch.seconds();
    return cost;
}

std::string words_of(const FixedCost& cost) {
    const std::string text =
        fmt::format("parse {:.3f} s, evaluate {:.3f} s", cost.parse, cost.evaluate);
    if (!cost.failure.empty()) return text + "; it cannot be rendered: " + cost.failure;
    return fmt::format("{:.3f} s before the first ray, once for each part: {}, build {:.3f} s",
                       cost.parse + cost.evaluate + cost.build, text, cost.build);
}

std::string to_text(const Scene& scene, const SceneSummary& summary, const FixedCost& cost) {
    std::string out;
    const auto row = [&out](const char* name, const std::string& text) {
        out += fmt::format("{:<10} {}\n", name, text);
    };
    row("picture",
        fmt::format("{} x {}, {} rays per pixel, {} levels", scene.width, scene.height,
                    scene.settings.samples * scene.settings.samples, scene.settings.max_depth));
    std::string cameras;
    for (const Camera& camera : scene.cameras) {
        cameras += fmt::format("{}{}{}({})", cameras.empty() ? "" : "; ", camera.name,
                               camera.name.empty() ? "" : " ", projection_of(camera));
    }
    row("cameras", cameras.empty() ? "none" : cameras);
    row("lights", list_of(summary.lights));
    row("shapes", list_of(summary.shapes));
    if (summary.triangles > 0) {
        row("triangles", fmt::format("{}, in {} stored mesh{}", summary.triangles, summary.meshes,
                                     summary.meshes == 1 ? "" : "es"));
    }
    row("surfaces", fmt::format("{}, {}, {}", list_of({{"material", summary.materials}}),
                                list_of({{"texture", summary.textures}}),
                                list_of({{"image", summary.images}})));
    row("level", fmt::format("{}: rays side by side, by this processor", name_of(best_level())));
    row("fixed cost", words_of(cost));
    out += fmt::format("\nIt requires of the renderer{}\n",
                       summary.requirements.empty() ? " nothing special" : ":");
    for (const Requirement& r : summary.requirements) {
        out += fmt::format("  {:<17} {}\n  {:<17} {}: {}\n", name_of(r.feature),
                           meaning_of(r.feature), "", r.place, r.by);
    }
    return out;
}

nlohmann::ordered_json as_json(const std::vector<Count>& counts) {
    auto json = nlohmann::ordered_json::object();
    for (const auto& [kind, number] : counts) json[std::string(kind)] = number;
    return json;
}

std::string to_json(const std::string& path, const Scene& scene, const SceneSummary& summary,
                    const FixedCost& cost) {
    nlohmann::ordered_json json;
    json["scene"] = path;
    json["picture"] = {{"width", scene.width},
                       {"height", scene.height},
                       {"samples", scene.settings.samples},
                       {"max_depth", scene.settings.max_depth}};
    json["cameras"] = nlohmann::ordered_json::array();
    for (const Camera& camera : scene.cameras)
        json["cameras"].push_back({{"name", camera.name}, {"projection", projection_of(camera)}});
    json["lights"] = as_json(summary.lights);
    json["shapes"] = as_json(summary.shapes);
    json["triangles"] = summary.triangles;
    json["meshes"] = summary.meshes;
    json["materials"] = summary.materials;
    json["textures"] = summary.textures;
    json["images"] = summary.images;
    json["level"] = name_of(best_level());
    json["fixed_cost"] = {{"parse", cost.parse}, {"evaluate", cost.evaluate}};
    json["fixed_cost"]["build"] =
        cost.failure.empty() ? nlohmann::ordered_json(cost.build) : nlohmann::ordered_json();
    json["requires"] = nlohmann::ordered_json::array();
    for (const Requirement& r : summary.requirements) {
        json["requires"].push_back({{"feature", name_of(r.feature)},
                                    {"meaning", meaning_of(r.feature)},
                                    {"by", r.by},
                                    {"place", r.place}});
    }
    // Names in a scene may come from the command line, so they need not be UTF-8.
    return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

ExitCode info(const InfoJob& job, Session& session) {
    SceneLoader loader(job.scene, job.scene_options, session);
    const Scene scene = loader.load();
    const SceneSummary summary = summarize(scene, session.sources);
    const FixedCost cost = cost_of(loader, scene);
    session.output.put(job.json ? to_json(job.scene, scene, summary, cost)
                                : to_text(scene, summary, cost));
    return ExitCode::done;
}

}  // namespace

void add_info(CLI::App& app, Action& action) {
    CLI::App& command = *app.add_subcommand(
        "info", "Show what a scene contains, what it requires of the renderer, and why");
    const auto job = std::make_shared<InfoJob>();
    command.add_option("SCENE", job->scene, "Scene file; - reads standard input")
        ->required()
        ->type_name("");
    command.add_flag("--json", job->json, "Print JSON");
    add_scene_options(command, job->scene_options);
    command.footer(
        "Examples:"
        "\n  lancer info scene.lancer");
    command.callback(
        [&action, job] { action = [job](Session& session) { return info(*job, session); }; });
}

}  // namespace lancer::cli
