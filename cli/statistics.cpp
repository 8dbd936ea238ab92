#include "cli/statistics.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <tuple>

namespace lancer::cli {
namespace {

double rays_per_second(const Statistics& s) {
    const std::uint64_t rays =
        s.rays.primary + s.rays.shadow + s.rays.reflected + s.rays.transmitted;
    return s.trace > 0 ? static_cast<double>(rays) / s.trace : 0;
}

nlohmann::ordered_json if_finite(double value) {
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json();
}

nlohmann::ordered_json off_json(const accuracy::OffReport& off, bool audited) {
    const auto if_told = [&](double value) {
        return audited ? nlohmann::ordered_json(value) : nlohmann::ordered_json();
    };
    return {{"steps", off.steps},
            {"asked", off.asked},
            {"share", if_told(off.estimate.share)},
            {"low", if_told(off.estimate.low)},
            {"high", if_told(off.estimate.high)},
            {"predicted", off.predicted}};
}

/// Values that are not told are null.
nlohmann::ordered_json error_json(const accuracy::ErrorReport& r) {
    const auto if_told = [&](double value) {
        return r.is_told ? nlohmann::ordered_json(value) : nlohmann::ordered_json();
    };
    nlohmann::ordered_json json{
        {"rmse", if_told(r.error.rmse)},
        {"low", if_told(r.error.low)},
        {"high", if_told(r.error.high)},
        {"asked", r.asked > 0 ? nlohmann::ordered_json(r.asked) : nlohmann::ordered_json()},
        {"audit_rays", r.printed.primary},
        {"deciding_rays", r.deciding.primary},
        {"picture_rays", r.picture.primary},
        {"predicted", r.predicted},
        {"max_depth", r.limits.max_depth},
        {"min_contribution", r.limits.min_contribution},
        {"reached", r.is_reached()}};
    if (r.passes > 0) json["passes"] = r.passes;
    if (r.off) json["off"] = off_json(*r.off, r.audited);
    return json;
}

}  // namespace

void Statistics::add(const RayCounts& counts) {
    rays.primary += counts.primary;
    rays.shadow += counts.shadow;
    rays.reflected += counts.reflected;
    rays.transmitted += counts.transmitted;
    rays.media_lost += counts.media_lost;
}

void Statistics::count(const Scene& scene, const WorldCounts& counts) {
    world = counts;
    cameras = scene.cameras.size();
    materials = scene.materials.size();
    textures = scene.textures.size();
}

void Statistics::keep_worse(const accuracy::ErrorReport& report) {
    const auto badness = [](const accuracy::ErrorReport& r) {
        const double rmse = r.audited ? r.error.rmse : r.predicted;
        return std::tuple(!r.is_reached(), r.off ? r.off->estimate.high : 0, rmse);
    };
    if (!error || badness(report) > badness(*error)) error = report;
}

void Statistics::keep_larger(const accuracy::CutBound& bound) {
    if (!cut || bound.largest > cut->largest) cut = bound;
}

std::uint64_t peak_memory_bytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

std::string to_json(const Statistics& s) {
    nlohmann::ordered_json json{
        {"seconds",
         {{"parse", s.parse},
          {"evaluate", s.evaluate},
          {"build", s.build},
          {"trace", s.trace},
          {"write", s.write},
          {"total", s.total}}},
        {"rays",
         {{"primary", s.rays.primary},
          {"shadow", s.rays.shadow},
          {"reflected", s.rays.reflected},
          {"transmitted", s.rays.transmitted}}},
        {"rays_per_second", rays_per_second(s)},
        {"threads", s.threads},
        {"level", s.level},
        {"peak_memory_bytes", peak_memory_bytes()},
        {"media_lost", s.rays.media_lost},
        {"frames", s.frames},
        {"counts",
         {{"shapes", s.world.shapes},
          {"triangles", s.world.triangles},
          {"lights", s.world.lights},
          {"nodes", s.world.nodes},
          {"cameras", s.cameras},
          {"materials", s.materials},
          {"textures", s.textures}}},
    };
    if (s.error) json["error"] = error_json(*s.error);
    if (s.cut)
        json["cut"] = {{"largest", if_finite(s.cut->largest)}, {"rmse", if_finite(s.cut->rmse)}};
    return json.dump(2) + "\n";
}

std::string to_text(const Statistics& s) {
    std::string out;
    const auto row = [&out](const char* name, const std::string& value) {
        out += fmt::format("{:<12} {:>14}\n", name, value);
    };
    const auto seconds = [](double value) { return fmt::format("{:.3f} s", value); };
    row("parse", seconds(s.parse));
    row("evaluate", seconds(s.evaluate));
    row("build", seconds(s.build));
    row("trace", seconds(s.trace));
    row("write", seconds(s.write));
    row("total", seconds(s.total));
    row("primary", fmt::format("{} rays", s.rays.primary));
    row("shadow", fmt::format("{} rays", s.rays.shadow));
    row("reflected", fmt::format("{} rays", s.rays.reflected));
    row("transmitted", fmt::format("{} rays", s.rays.transmitted));
    row("speed", fmt::format("{:.0f} rays/s", rays_per_second(s)));
    row("threads", fmt::format("{}", s.threads));
    row("level", s.level);
    row("memory", fmt::format("{:.1f} MB", static_cast<double>(peak_memory_bytes()) / 1e6));
    row("shapes", fmt::format("{}", s.world.shapes));
    row("triangles", fmt::format("{}", s.world.triangles));
    row("lights", fmt::format("{}", s.world.lights));
    return out;
}

}  // namespace lancer::cli
