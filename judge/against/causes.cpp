#include "judge/against/causes.h"

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <utility>

#include "judge/against/light_fit.h"
#include "judge/against/scene_variants.h"
#include "judge/against/shift_fit.h"
#include "judge/validate/our_renderer.h"

namespace lancer::judge {

namespace {

/// With fewer different pixels than this, or a smaller share of all, no cause for the whole picture
/// is looked for.
constexpr std::size_t least_different = 8;
constexpr std::size_t one_in = 2000;
constexpr std::size_t most_different = 6000;
constexpr std::size_t most_agreeing = 3000;
/// A scene with more triangles takes long to build, so its variants are not tried.
constexpr std::uint64_t most_triangles = 300'000;
/// The limit on the triangles of all variants together.
constexpr std::uint64_t most_built = 15'000'000;

/// Every n-th of the pixels, about `most` of them.
std::vector<std::size_t> thinned(const std::vector<std::size_t>& pixels, std::size_t most) {
    const std::size_t step = pixels.size() / most + 1;
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < pixels.size(); i += step) kept.push_back(pixels[i]);
    return kept;
}

TrialPixels samples_of(const Image& ours, const Image& theirs, const Reading& reading, bool clipped,
                       double tolerance) {
    TrialPixels samples;
    samples.tolerance = tolerance;
    samples.exposure = reading.exposure;
    samples.clipped = clipped;
    std::vector<std::size_t> different;
    std::vector<std::size_t> agreeing;
    const auto width = static_cast<std::size_t>(ours.width);
    const auto place = [&](std::size_t i) {
        return std::pair{static_cast<int>(i % width), static_cast<int>(i / width)};
    };
    for (std::size_t i = 0; i < width * static_cast<std::size_t>(ours.height); ++i) {
        const auto [x, y] = place(i);
        const bool agrees = distance(color_at(ours, x, y), color_at(theirs, x, y)) <= tolerance;
        (agrees ? agreeing : different).push_back(i);
    }
    const auto take = [&](const std::vector<std::size_t>& pixels) {
        for (const std::size_t i : pixels) {
            const auto [x, y] = place(i);
            samples.points.push_back({x + reading.center_x, y + reading.center_y});
            samples.theirs.push_back(color_at(theirs, x, y));
        }
        return pixels.size();
    };
    samples.different = take(thinned(different, most_different));
    take(thinned(agreeing, most_agreeing));
    return samples;
}

/// Keeps the best explanation that convinces; of two equal ones, the first.
class Best {
  public:
    explicit Best(const TrialPixels& samples) : samples_(samples) {}

    void consider(Explanation explanation) {
        if (found_) return;
        const Effect effect = effect_of(samples_, explanation);
        if (!effect.convinces()) return;
        const double gain = effect.repaired - effect.spoilt;
        if (cause_ && gain <= gain_ + 0.005) return;
        cause_ = Cause{std::move(explanation.words), explanation.is_shift};
        gain_ = gain;
        found_ = effect.is_perfect();
    }
    void consider(const std::vector<Explanation>& explanations) {
        for (const Explanation& explanation : explanations) consider(explanation);
    }
    /// True when no better explanation is possible.
    bool found() const { return found_; }
    const std::optional<Cause>& cause() const { return cause_; }

  private:
    const TrialPixels& samples_;
    std::optional<Cause> cause_;
    double gain_ = 0;
    bool found_ = false;
};

/// The colours that an explanation predicts at points of the picture.
using Look = std::function<std::vector<Color>(const std::vector<PicturePoint>&)>;

/// Looks at all samples only where it may convince: at a few of those that differ it must hold for
/// more than the chance of drawing them leaves open.
void consider_look(Best& best, const TrialPixels& samples, std::string words, const Look& look) {
    constexpr std::size_t most_first = 400;
    const TrialPixels few = few_of(samples, most_first);
    if (effect_of(few, {"", look(few.points)}).repaired < 0.75) return;
    best.consider(Explanation{std::move(words), look(samples.points)});
}

void consider_variant(Best& best, const TrialPixels& samples, const VariantTracer& tracer,
                      const Scene& original, const SceneVariant& variant) {
    Scene scene = original;
    variant.change(scene);
    try {
        const auto renderer = compile(scene, scene.settings);
        consider_look(best, samples, variant.words, [&](std::vector<PicturePoint> points) {
            if (variant.mirrored)
                for (PicturePoint& p : points) p.x = tracer.view().width - p.x;
            return tracer.trace(*renderer, scene.settings, points);
        });
    } catch (const SceneError&) {
        // The other program cannot have rendered this variant either.
    }
}

}  // namespace

std::vector<Suspect> suspects_of(const Judgement& judgement, const ProbeFunction& probe) {
    constexpr std::size_t most_looks = 4000;
    std::vector<std::size_t> unexplained;
    for (std::size_t i = 0; i < judgement.different.size(); ++i)
        if (judgement.different[i].pixel_class == PixelClass::unexplained) unexplained.push_back(i);
    std::map<std::uint32_t, std::size_t> counts;
    const std::vector<std::size_t> looked_at = thinned(unexplained, most_looks);
    for (const std::size_t i : looked_at) {
        const DifferentPixel& pixel = judgement.different[i];
        const std::uint32_t object = probe(pixel.x + 0.5, pixel.y + 0.5).object;
        if (object != none) ++counts[object];
    }
    std::vector<Suspect> suspects;
    for (const auto& [object, count] : counts)
        suspects.push_back({object, count * unexplained.size() / looked_at.size()});
    std::stable_sort(suspects.begin(), suspects.end(),
                     [](const Suspect& a, const Suspect& b) { return a.pixels > b.pixels; });
    if (suspects.size() > 3) suspects.resize(3);
    return suspects;
}

bool shift_brings_nearer(const Image& ours, const Image& theirs, const Judgement& judgement,
                         const ProbeFunction& probe) {
    constexpr std::size_t most_looks = 1000;
    constexpr double edge = 0.05;  // larger differences say no more about a shift
    const Shift& shift = judgement.picture_shift;
    // Registration follows slopes, which say nothing about longer shifts.
    if (!(shift.length() < 2)) return false;
    std::vector<std::size_t> different;
    for (std::size_t i = 0; i < judgement.different.size(); ++i) different.push_back(i);
    double before = 0;
    double after = 0;
    for (const std::size_t i : thinned(different, most_looks)) {
        const auto [x, y] = std::pair{judgement.different[i].x, judgement.different[i].y};
        const Color there = color_at(theirs, x, y);
        const Color moved = probe(x + 0.5 - shift.x, y + 0.5 - shift.y).color;
        before += std::min(edge, distance(color_at(ours, x, y), there));
        after += std::min(edge, distance(moved, there));
    }
    return different.empty() || after < 0.9 * before;
}

std::optional<Cause> likely_cause(const ValidationJob& job, const Image& ours, const Image& theirs,
                                  const Judgement& judgement, const Reading& reading, bool clipped,
                                  const ProbeFunction& probe) {
    TrialPixels samples =
        samples_of(ours, theirs, reading, clipped, job.expect.thresholds.interior);
    if (judgement.different.size() < std::max(least_different, judgement.pixels / one_in))
        return std::nullopt;
    const Scene& scene = *job.scene;
    const VariantTracer tracer(tracer_view(job.view), samples);
    const auto renderer = compile(scene, scene.settings);
    // These values are not clipped, while `ours` is: an explanation may darken values above 1.
    samples.ours = tracer.trace(*renderer, scene.settings, samples.points);

    Best best(samples);
    best.consider(value_fits(samples));
    if (!best.found()) best.consider(turned_pictures(samples, tracer, scene, *renderer));
    if (!best.found()) {
        best.consider(
            shifted_picture(samples, tracer, scene, *renderer, reading.center_x, reading.center_y));
    }
    const std::uint64_t triangles = renderer->counts().triangles;
    if (triangles > most_triangles) return best.cause();
    if (!best.found()) best.consider(other_lights(samples, tracer, job));
    if (!best.found()) {
        std::vector<std::size_t> objects;
        for (const Suspect& suspect : suspects_of(judgement, probe))
            objects.push_back(suspect.object);
        std::uint64_t built = 0;
        for (const SceneVariant& variant : scene_variants(job, job.view.camera, objects)) {
            built += triangles;
            if (best.found() || built > most_built) break;
            consider_variant(best, samples, tracer, scene, variant);
        }
    }
    if (!best.found()) best.consider(other_falloffs(samples, tracer, job));
    return best.cause();
}

}  // namespace lancer::judge
