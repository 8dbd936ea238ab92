#include "judge/pack/pack.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "judge/pack/exact_picture.h"
#include "judge/pack/packed_scene.h"
#include "judge/pack/readme_text.h"
#include "judge/pack/scene_json.h"
#include "judge/validate/our_renderer.h"
#include "model/io/pfm_file.h"

namespace lancer::judge {

namespace {

constexpr const char* format_name = "lancer-pack 1";

/// {"file", "error"}: the error includes the rounding to the file's floats.
Json picture_json(PackSink& sink, const Image& image, const char* name, int begin, int count,
                  double error) {
    const std::string file = std::string(name) + ".pfm";
    sink.files.push_back({file, io::encode_pfm(image, begin, count)});
    return {{"file", file}, {"error", error}, {"relative_error", 0x1p-24}};
}

}  // namespace

Pack pack_scene(const ValidationJob& job, std::size_t probes) {
    Pack pack;
    Scene scene = as_packed(*job.scene, pack.warnings);
    round_images(scene);
    PackSink sink(scene, job.place_text);
    Json json;
    json["format"] = format_name;
    json["name"] = job.name;
    json["source"] = job.path;
    json["width"] = job.view.width;
    json["height"] = job.view.height;
    json.update(scene_json(scene, job.view.camera, sink));
    const View view = tracer_view(job.view);
    const ExactPicture exact = exact_picture(scene, view);
    Json& pictures = json["pictures"];
    pictures["color"] = picture_json(sink, exact.image, "color", 0, 3, exact.color_error);
    pictures["object"] = picture_json(sink, exact.image, "object", 3, 1, 0);
    pictures["depth"] = picture_json(sink, exact.image, "depth", 4, 1, 0);
    pictures["depth"]["relative_error"] = exact.depth_error + 0x1p-24;
    pictures["normal"] = picture_json(sink, exact.image, "normal", 5, 3, exact.normal_error);
    pictures["shadow"] = picture_json(sink, exact.image, "shadow", 8, 1, 0);
    Json undecided = Json::array();
    for (std::size_t i = 0; i < exact.is_undecided.size(); ++i) {
        if (exact.is_undecided[i] == 0) continue;
        const auto width = static_cast<std::size_t>(view.width);
        undecided.push_back({i % width, i / width});
    }
    pack.undecided = undecided.size();
    json["undecided"] = std::move(undecided);
    json["probes"] = exact_probes(scene, view, exact, probes);
    pack.probes = json["probes"].size();
    pack.files = std::move(sink.files);
    // Names in a scene may hold any bytes.
    pack.files.push_back(
        {"scene.json", json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n"});
    return pack;
}

std::string pack_readme() {
    return std::string(readme_text);
}

std::string pack_index(const std::vector<std::string>& names, const std::string& lancer_version) {
    const Json json{
        {"format", format_name}, {"made_by", "lancer " + lancer_version}, {"scenes", names}};
    return json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

bool is_pack_index(const std::string& text) {
    const Json json = Json::parse(text, nullptr, false);
    return json.is_object() && json.value("format", Json()) == format_name;
}

}  // namespace lancer::judge
