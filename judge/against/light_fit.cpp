#include "judge/against/light_fit.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "judge/validate/place_words.h"
#include "model/light_facts.h"

namespace lancer::judge {

namespace {

/// The light that one source contributes to the samples.
struct Source {
    std::string words;
    std::vector<Color> brought;
    std::array<double, 3> excess{0, 0, 0};  ///< its factor in the other picture, minus 1
};

std::vector<Color> less(const std::vector<Color>& a, const std::vector<Color>& b) {
    std::vector<Color> result;
    result.reserve(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) result.push_back(a[i] - b[i]);
    return result;
}

bool brings_anything(const Source& source) {
    return std::any_of(source.brought.begin(), source.brought.end(), [](const Color& c) {
        return std::abs(c.x) > 1e-9 || std::abs(c.y) > 1e-9 || std::abs(c.z) > 1e-9;
    });
}

std::vector<Source> sources_of(const TrialPixels& samples, const VariantTracer& tracer,
                               const ValidationJob& job) {
    std::vector<Source> sources;
    const auto add = [&](std::string words, const auto& put_out) {
        Scene without = *job.scene;
        put_out(without);
        Source source{std::move(words), less(samples.ours, tracer.trace(without))};
        if (brings_anything(source)) sources.push_back(std::move(source));
    };
    for (std::size_t i = 0; i < std::min(most_lights, job.scene->lights.size()); ++i)
        add(light_words(job, i), [i](Scene& scene) { scene.lights[i].color = Color(0); });
    add("the ambient light", [](Scene& scene) { scene.ambient = Color(0); });
    add("the background", [](Scene& scene) { scene.background = Color(0); });
    if (job.scene->sky)
        add("the sky", [](Scene& scene) {
            for (Gradient::Stop& stop : scene.sky->stops) stop.color = Color(0);
        });
    return sources;
}

bool is_clipped(const TrialPixels& samples, std::size_t i, int c) {
    return samples.clipped && (samples.ours[i][c] >= 1 || samples.theirs[i][c] >= 1);
}

/// Solves the normal equations of one channel by Gauss and Jordan with the largest pivots; sources
/// that cannot be told from others keep 0.
void fit_channel(const TrialPixels& samples, std::vector<Source>& sources, int c) {
    const std::size_t n = sources.size();
    std::vector<std::vector<double>> rows(n, std::vector<double>(n + 1, 0));
    for (std::size_t i = 0; i < samples.ours.size(); ++i) {
        if (is_clipped(samples, i, c)) continue;
        const double difference = samples.theirs[i][c] - samples.ours[i][c];
        for (std::size_t a = 0; a < n; ++a) {
            const double weight = sources[a].brought[i][c];
            if (weight == 0) continue;
            for (std::size_t b = 0; b < n; ++b) rows[a][b] += weight * sources[b].brought[i][c];
            rows[a][n] += weight * difference;
        }
    }
    std::vector<double> sizes;
    for (std::size_t a = 0; a < n; ++a) sizes.push_back(rows[a][a]);
    std::vector<bool> done(n, false);
    for (;;) {
        std::optional<std::size_t> pivot;
        for (std::size_t a = 0; a < n; ++a) {
            if (done[a] || !(rows[a][a] > 1e-9 * sizes[a]) || rows[a][a] <= 0) continue;
            if (!pivot || rows[a][a] > rows[*pivot][*pivot]) pivot = a;
        }
        if (!pivot) break;
        done[*pivot] = true;
        const double scale = 1 / rows[*pivot][*pivot];
        for (double& value : rows[*pivot]) value *= scale;
        for (std::size_t a = 0; a < n; ++a) {
            if (a == *pivot) continue;
            const double factor = rows[a][*pivot];
            for (std::size_t b = 0; b <= n; ++b) rows[a][b] -= factor * rows[*pivot][b];
        }
    }
    for (std::size_t a = 0; a < n; ++a)
        sources[a].excess[static_cast<std::size_t>(c)] = done[a] ? rows[a][n] : 0;
}

double largest_excess(const Source& source) {
    double largest = 0;
    for (const double e : source.excess) largest = std::max(largest, std::abs(e));
    return largest;
}

std::string brightness_words(const Source& source) {
    const auto [least, most] = std::minmax_element(source.excess.begin(), source.excess.end());
    const double mean = (source.excess[0] + source.excess[1] + source.excess[2]) / 3;
    if (*most - *least <= 1e-3 + 0.02 * std::abs(mean)) {
        if (mean < -0.999) return source.words + " is missing";
        return fmt::format("{} is {} times as bright as in Lancer's picture", source.words,
                           factor_text(1 + mean));
    }
    return fmt::format("{} is {}, {} and {} times as bright in red, green and blue", source.words,
                       factor_text(1 + source.excess[0]), factor_text(1 + source.excess[1]),
                       factor_text(1 + source.excess[2]));
}

struct Law {
    std::string words;
    std::optional<Fade> fade;
    double brightness = 1;  ///< makes the light contribute about as much as before
};

const std::optional<Fade>* fade_of(const Light& light) {
    return facts_of(light.kind).fade;
}

void set_fade(Light& light, const std::optional<Fade>& fade) {
    const auto set = [&](auto& kind) {
        if constexpr (requires { kind.fade; }) kind.fade = fade;
    };
    std::visit(set, light.kind);
}

/// Falloff laws of other programs. If the distance in our formula is small against all distances in
/// the scene, its 1 is negligible, and it becomes the plain inverse power. `far` is a length of the
/// scene's size.
std::vector<Law> laws_for(const std::optional<Fade>& ours, double far) {
    constexpr double small = 1e-4;
    std::vector<Law> laws;
    if (ours) laws.push_back({"does not fall off", std::nullopt});
    laws.push_back(
        {"falls off with the square of the distance", Fade{small * far, 2}, 1 / (small * small)});
    laws.push_back({"falls off with the distance", Fade{small * far, 1}, 1 / small});
    for (const double power : {1.0, 2.0}) {
        const Fade plain{ours ? ours->distance : 1, power};
        if (ours && ours->power == power) continue;
        laws.push_back(
            {fmt::format("falls off by 1/(1 + (d/{:g})^{:g})", plain.distance, power), plain});
    }
    return laws;
}

std::string ours_words(const std::optional<Fade>& fade) {
    if (!fade) return "in Lancer's picture it does not";
    return fmt::format("in Lancer's picture it does by 2/(1 + (d/{:g})^{:g})", fade->distance,
                       fade->power);
}

}  // namespace

std::vector<Explanation> other_lights(const TrialPixels& samples, const VariantTracer& tracer,
                                      const ValidationJob& job) {
    std::vector<Source> sources = sources_of(samples, tracer, job);
    if (sources.empty()) return {};
    for (int c = 0; c < 3; ++c) fit_channel(samples, sources, c);
    std::vector<Color> colors = samples.ours;
    double largest = 0;
    for (const Source& source : sources) largest = std::max(largest, largest_excess(source));
    std::vector<std::string> words;
    for (const Source& source : sources) {
        for (std::size_t i = 0; i < colors.size(); ++i)
            for (int c = 0; c < 3; ++c)
                colors[i][c] += source.excess[static_cast<std::size_t>(c)] * source.brought[i][c];
        if (largest_excess(source) > 1e-3 && largest_excess(source) > 0.05 * largest)
            words.push_back(brightness_words(source));
    }
    if (words.empty()) return {};
    return {{fmt::format("{}", fmt::join(words, "; ")), std::move(colors)}};
}

std::vector<Explanation> other_falloffs(const TrialPixels& samples, const VariantTracer& tracer,
                                        const ValidationJob& job) {
    std::vector<Explanation> found;
    std::vector<std::size_t> placed;  // lights whose falloff can change
    for (std::size_t i = 0; i < job.scene->lights.size(); ++i)
        if (fade_of(job.scene->lights[i]) != nullptr) placed.push_back(i);
    if (placed.empty() || placed.size() > most_lights) return found;
    const Camera& camera = job.scene->cameras[job.view.camera];
    const double far = length(camera.look_at - camera.position);
    std::vector<std::vector<std::size_t>> sets;
    for (const std::size_t light : placed) sets.push_back({light});
    if (placed.size() > 1) sets.push_back(placed);
    for (const std::vector<std::size_t>& set : sets) {
        const std::optional<Fade>& ours = *fade_of(job.scene->lights[set.front()]);
        Scene off = *job.scene;
        for (const std::size_t i : set) off.lights[i].color = Color(0);
        const std::vector<Color> dark = tracer.trace(off);
        for (const Law& law : laws_for(ours, far)) {
            Scene other = *job.scene;
            for (const std::size_t i : set) {
                set_fade(other.lights[i], law.fade);
                other.lights[i].color = other.lights[i].color * law.brightness;
            }
            const std::vector<Color> brought = less(tracer.trace(other), dark);
            double product = 0;
            double square = 0;
            for (std::size_t i = 0; i < brought.size(); ++i) {
                for (int c = 0; c < 3; ++c) {
                    if (is_clipped(samples, i, c)) continue;
                    product += brought[i][c] * (samples.theirs[i][c] - dark[i][c]);
                    square += brought[i][c] * brought[i][c];
                }
            }
            if (!(square > 0) || !(product > 0)) continue;
            std::vector<Color> colors = dark;
            for (std::size_t i = 0; i < colors.size(); ++i)
                colors[i] = colors[i] + brought[i] * (product / square);
            const std::string which =
                set.size() == 1 ? light_words(job, set.front()) : "each of the lights";
            found.push_back(
                {fmt::format("{} {}; {}", which, law.words, ours_words(ours)), std::move(colors)});
        }
    }
    return found;
}

}  // namespace lancer::judge
