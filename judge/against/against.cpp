#include "judge/against/against.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>

#include "judge/against/causes.h"
#include "judge/validate/place_words.h"

namespace lancer::judge {

namespace {

/// The colour as the other picture stores it.
Color held(const Color& color, double exposure, bool clipped) {
    Color result = color * exposure;
    if (clipped)
        for (int c = 0; c < 3; ++c) result[c] = std::clamp(result[c], 0.0, 1.0);
    return result;
}

/// Whether the proportions are the scene's, except for rounding by up to a pixel.
bool has_proportions(const Image& picture, const Scene& scene) {
    const double height = static_cast<double>(picture.width) * scene.height / scene.width;
    return std::abs(height - picture.height) < 1;
}

/// Why the picture cannot show this view; empty when it can.
std::string size_problem(const Image& picture, const AgainstJob& job) {
    const reference::ExportView& view = job.scene.view;
    const Scene& scene = *job.scene.scene;
    if (job.size_is_given && (picture.width != view.width || picture.height != view.height)) {
        return fmt::format("the picture has {} x {} pixels, but --size says {} x {}", picture.width,
                           picture.height, view.width, view.height);
    }
    if (job.size_is_given || has_proportions(picture, scene)) return {};
    return fmt::format(
        "the picture has {} x {} pixels, but the scene's {} x {} have other proportions: the "
        "picture is cropped or shows another view. If it shows the whole view, give --size {}x{}",
        picture.width, picture.height, scene.width, scene.height, picture.width, picture.height);
}

/// Reports values that are not finite, before anything is rendered.
std::string non_finite_problem(const Image& picture) {
    const auto bad = std::find_if(picture.data.begin(), picture.data.end(),
                                  [](double v) { return !std::isfinite(v); });
    if (bad == picture.data.end()) return {};
    const auto count = std::count_if(picture.data.begin(), picture.data.end(),
                                     [](double v) { return !std::isfinite(v); });
    const auto pixel = static_cast<std::size_t>(bad - picture.data.begin()) / 3;
    const auto width = static_cast<std::size_t>(picture.width);
    return fmt::format("the picture has {} value{} NaN or infinite, the first at ({}, {})", count,
                       count == 1 ? " that is" : "s that are", pixel % width, pixel / width);
}

struct OurSide {
    Image image;
    ProbeFunction probe;  ///< (0.5, 0.5) is the point of the other program's first ray
    std::uint64_t rays = 0;
};

OurSide render(const AgainstJob& job, const View& view, bool clipped) {
    const Scene& scene = *job.scene.scene;
    const Reading& reading = job.reading;
    Settings settings = scene.settings;
    settings.threads = 1;  // whole scenes run side by side
    const std::shared_ptr<const Renderer> renderer = compile(scene, settings);
    std::vector<PicturePoint> points;
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x)
            points.push_back({x + reading.center_x, y + reading.center_y});
    std::vector<Color> colors(points.size());
    RayCounts rays;
    renderer->trace(view, points, {settings.max_depth, settings.min_contribution}, colors, {},
                    rays);
    OurSide ours{Image(view.width, view.height), {}, rays.rays()};
    for (std::size_t i = 0; i < colors.size(); ++i) {
        const Color color = held(colors[i], reading.exposure, clipped);
        for (int c = 0; c < 3; ++c) ours.image.data[3 * i + static_cast<std::size_t>(c)] = color[c];
    }
    ours.probe = [renderer, view, reading, clipped](double x, double y) {
        Probe probe = renderer->probe(view, x - 0.5 + reading.center_x, y - 0.5 + reading.center_y);
        probe.color = held(probe.color, reading.exposure, clipped);
        return probe;
    };
    return ours;
}

/// Pairs of objects with coincident faces that rays can reach. A picture cannot tell which of the
/// two a program finds.
std::vector<reference::Coincidence> undecidable(const ValidationJob& job) {
    reference::ExportOptions options;
    options.name = job.name;
    std::vector<reference::Coincidence> found =
        reference::export_pov(*job.scene, job.view, options).coincidences;
    std::erase_if(found, [](const reference::Coincidence& c) {
        return c.resolution == reference::Coincidence::Resolution::hidden;
    });
    return found;
}

/// There must be one.
const DifferentPixel& worst_unexplained(const Judgement& judgement) {
    return *std::max_element(judgement.different.begin(), judgement.different.end(),
                             [](const DifferentPixel& a, const DifferentPixel& b) {
                                 const auto size = [](const DifferentPixel& p) {
                                     return p.pixel_class == PixelClass::unexplained ? p.difference
                                                                                     : -1;
                                 };
                                 return size(a) < size(b);
                             });
}

std::string values_at(const Image& image, const DifferentPixel& p) {
    const double* v = image.pixel(p.x, p.y);
    return fmt::format("[{:.4g}, {:.4g}, {:.4g}]", v[0], v[1], v[2]);
}

void tell_where(Validation& result, const ValidationJob& job, const ProbeFunction& probe) {
    const std::size_t unexplained = result.judgement.count(PixelClass::unexplained);
    if (unexplained == 0) return;
    for (const Suspect& suspect : suspects_of(result.judgement, probe)) {
        if (suspect.pixels * 10 < unexplained) continue;
        result.reasons.push_back(fmt::format("about {} of them show {}", suspect.pixels,
                                             object_words(job, suspect.object)));
    }
    const DifferentPixel& worst = worst_unexplained(result.judgement);
    result.reasons.push_back(
        fmt::format("the worst, {:.2g} off, is {},{}: {}, and {} in Lancer's picture; what its ray "
                    "does: lancer probe {} {},{} --size {}x{} --samples 1 --min-contribution 0",
                    worst.difference, worst.x, worst.y, values_at(result.theirs, worst),
                    values_at(result.ours, worst), job.scene_words, worst.x, worst.y,
                    job.view.width, job.view.height));
    if (!result.cause) {
        result.reasons.emplace_back(
            "no single cause that was tried explains all of it: docs/validation.md lists these "
            "causes, and the mistakes that cannot be tried");
        result.reasons.emplace_back(
            "a picture alone cannot show whether some of them are coincident surfaces, reference "
            "outliers or known differences of POV-Ray");
    }
    for (const reference::Coincidence& c : undecidable(job)) {
        result.reasons.push_back(
            fmt::format("faces of {} and {} coincide: where they are visible, a picture alone "
                        "cannot show which program is right",
                        object_words(job, c.first), object_words(job, c.second)));
        if (result.reasons.size() > 12) break;
    }
}

void judge(Validation& result, const AgainstJob& job) {
    const Reading& reading = job.reading;
    ForeignPicture foreign =
        read_foreign_picture(job.picture, reading.encoding, result.thresholds.interior);
    Image& picture = foreign.light;
    for (const std::string& problem : {size_problem(picture, job), non_finite_problem(picture)}) {
        if (problem.empty()) continue;
        result.verdict = Verdict::differs;
        result.reasons.push_back(problem);
        return;
    }
    ValidationJob scene = job.scene;
    scene.view.width = picture.width;
    scene.view.height = picture.height;
    result.view = scene.view;
    const bool clipped =
        std::none_of(picture.data.begin(), picture.data.end(), [](double v) { return v > 1; });
    const auto start = std::chrono::steady_clock::now();
    OurSide ours = render(job, tracer_view(scene.view), clipped);
    result.our_seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    result.ours = std::move(ours.image);
    const bool is_lower = is_rounded_down(result.ours, foreign);
    result.theirs = is_lower ? std::move(foreign.raised) : std::move(foreign.light);
    if (!compare_pictures(result)) return;
    result.judgement = judge_pictures(result.ours, result.theirs, ours.probe, result.thresholds, {},
                                      rays_for_explaining(ours.rays));
    result.verdict = result.judgement.pass ? Verdict::agrees : Verdict::differs;
    result.reasons = result.judgement.failures;
    if (!result.judgement.pass) {
        const auto cause = likely_cause(scene, result.ours, result.theirs, result.judgement,
                                        reading, clipped, ours.probe);
        if (cause) result.cause = cause->words;
        tell_where(result, scene, ours.probe);
        const bool is_shifted =
            cause ? cause->is_shift
                  : shift_brings_nearer(result.ours, result.theirs, result.judgement, ours.probe);
        // The shift is kept as a reason if there is no other.
        if (!is_shifted && result.judgement.failures.size() > 1)
            std::erase(result.reasons, result.judgement.shift_failure);
    }
    if (is_lower) {
        result.reasons.emplace_back(
            "its numbers are rounded down, not to the nearest: half a step of 16 bits is added");
    }
}

}  // namespace

Validation validate_against(const AgainstJob& job) {
    return validation_of(job.scene, [&](Validation& result) {
        result.picture = job.picture;
        result.exposure = job.reading.exposure;
        judge(result, job);
    });
}

std::string picture_in_folder(const std::string& folder, const std::string& scene_path) {
    const std::string name = std::filesystem::path(scene_path).stem().string();
    for (const char* ending : {".exr", ".tif", ".tiff", ".png", ".ppm"}) {
        const std::filesystem::path file = std::filesystem::path(folder) / (name + ending);
        std::error_code ignored;
        if (std::filesystem::is_regular_file(file, ignored)) return file.string();
    }
    throw FileError(fmt::format(
        "there is no picture of '{}' in '{}': expected {}.exr, .tif, .tiff, .png or .ppm",
        scene_path, folder, name));
}

}  // namespace lancer::judge
