#include "judge/stability/stability.h"

#include <algorithm>
#include <cmath>

#include "judge/stability/sample_cache.h"
#include "judge/validate/our_renderer.h"
#include "model/diagnostic.h"
#include "model/similar.h"

namespace lancer::judge {
namespace {

struct KindOfChange {
    const char* name;
    int base;
};
KindOfChange kind_of(Change change) {
    switch (change) {
        case Change::scale:
            return {"scale", 10};
        case Change::twos:
            return {"twos", 2};
        case Change::shift:
            return {"shift", 10};
        case Change::distance:
            return {"distance", 10};
        case Change::axes:
            return {"axes", 0};
        case Change::extended:
            return {"extended", 0};
    }
    return {"", 0};
}

/// The distance of the camera from its look_at point.
double viewing_distance(const Camera& camera) {
    const Vec3d view = camera.look_at - camera.position;
    const double largest = max_component(absolute(view));
    return std::isfinite(largest) ? largest * length(view / largest) : 1;
}

const Sample* sample_at(const Window& window, int exponent) {
    const auto found = std::find_if(window.samples.begin(), window.samples.end(),
                                    [&](const Sample& s) { return s.exponent == exponent; });
    return found == window.samples.end() ? nullptr : &*found;
}

double clipped(double value) {
    return std::clamp(value, 0.0, 1.0);
}

void find_ends(Window& window) {
    std::sort(window.samples.begin(), window.samples.end(),
              [](const Sample& a, const Sample& b) { return a.exponent < b.exponent; });
    window.lowest = window.highest = window.trial.origin();
    for (const Sample& s : window.samples) {
        if (s.exponent < window.trial.origin()) continue;
        if (!s.right) break;
        window.highest = s.exponent;
    }
    for (auto s = window.samples.rbegin(); s != window.samples.rend(); ++s) {
        if (s->exponent > window.trial.origin()) continue;
        if (!s->right) break;
        window.lowest = s->exponent;
    }
}

}  // namespace

const char* name_of(Change change) {
    return kind_of(change).name;
}

int base_of(Change change) {
    return kind_of(change).base;
}

PreciseRenderer renderer_of(const reference::ExportView& view) {
    return [picture = tracer_view(view)](const Scene& scene, Precision precision) {
        Settings settings = scene.settings;
        settings.precision = precision;
        RayCounts rays;
        return compile(scene, settings)->render(picture, {}, rays);
    };
}

double power_of_ten(int exponent) {
    return static_cast<double>(elementary::pow(10.0L, static_cast<long double>(exponent)));
}

bool Window::holds(int low, int high) const {
    const auto reached = [this](int end) {
        return end == trial.origin() || sample_at(*this, end) != nullptr;
    };
    return reached(low) && reached(high) &&
           std::all_of(samples.begin(), samples.end(), [&](const Sample& s) {
               return s.exponent < low || s.exponent > high || s.right;
           });
}

bool Window::holds() const {
    return !cut_short &&
           std::all_of(samples.begin(), samples.end(), [](const Sample& s) { return s.right; });
}

Scene changed(const Scene& scene, Change change, int exponent) {
    switch (change) {
        case Change::scale:
            return scaled(scene, power_of_ten(exponent));
        case Change::twos:
            return scaled(scene, std::ldexp(1.0, exponent));
        case Change::shift:
            return moved(scene, Vec3d(power_of_ten(exponent)));
        case Change::distance:
            return seen_from_afar(scene, power_of_ten(exponent));
        case Change::axes:
            return axes_renamed(scene, exponent);
        case Change::extended:
            break;
    }
    return scene;
}

Trial default_trial(const Scene& scene, std::uint32_t camera, Change change) {
    switch (change) {
        case Change::scale:
        case Change::twos:
            return {change, -100, 100, {}};
        case Change::shift: {
            const double size = viewing_distance(scene.cameras[camera]);
            const int decade = static_cast<int>(std::floor(std::log10(size)));
            return {change, decade, decade + 16, {}};
        }
        case Change::distance:
            return {change, 0, 16, {}};
        case Change::axes:
            return {change, 0, 2, {}};
        case Change::extended:
            break;
    }
    return {change, 0, 0, {}};
}

Sample compare_to(const Image& reference, const Image& image, int exponent,
                  const StabilityOptions& options) {
    Sample sample;
    sample.exponent = exponent;
    const std::size_t pixels = reference.data.size() / 3;
    for (std::size_t i = 0; i < pixels; ++i) {
        double most = 0;
        bool same = true;
        for (std::size_t c = 3 * i; c < 3 * i + 3; ++c) {
            const double a = reference.data[c];
            const double b = image.data[c];
            same = same && a == b;
            const bool finite = std::isfinite(a) && std::isfinite(b);
            most = std::max(most, finite ? std::abs(clipped(a) - clipped(b)) : 1.0);
        }
        sample.most = std::max(sample.most, most);
        sample.wrong += most > options.fail ? 1 : 0;
        sample.different += same ? 0 : 1;
    }
    sample.right = static_cast<double>(sample.wrong) * 100 <=
                   options.fail_percent * static_cast<double>(pixels);
    return sample;
}

StabilityTest::StabilityTest(const Scene& scene, PreciseRenderer renderer,
                             const StabilityOptions& options, std::function<bool()> may_go_on,
                             SampleCache cache)
    : scene_(scene),
      render_(std::move(renderer)),
      options_(options),
      may_go_on_(std::move(may_go_on)),
      cache_(std::move(cache)) {}

bool StabilityTest::look(Window& window, int exponent) {
    if (exponent == window.trial.origin() && base_of(window.trial.change) != 0 &&
        window.trial.change != Change::distance)
        return true;  // the scene as it is
    if (sample_at(window, exponent) != nullptr) return true;
    if (!may_go_on_()) {
        window.cut_short = true;
        return false;
    }
    const Change change = window.trial.change;
    if (const std::optional<Sample> kept = kept_sample(cache_, change, exponent)) {
        window.samples.push_back(*kept);
        return true;
    }
    window.samples.push_back(sample_of(change, exponent));
    if (cache_.grows) keep_sample(cache_, change, window.samples.back());
    return true;
}

Sample StabilityTest::sample_of(Change change, int exponent) {
    const Precision own = scene_.settings.precision;
    if (!unchanged_) unchanged_ = render_(scene_, own);
    Sample sample;
    try {
        const Scene other = changed(scene_, change, exponent);
        const Image image = render_(other, change == Change::extended ? Precision::extended : own);
        const bool is_afar = change == Change::distance;
        sample = compare_to(is_afar ? render_(other, Precision::extended) : *unchanged_, image,
                            exponent, options_);
        if (change == Change::twos) sample.right = sample.different == 0;
    } catch (const SceneError& error) {
        sample.exponent = exponent;
        sample.failure = error.what();
        sample.wrong = sample.different = unchanged_->data.size() / 3;
        sample.most = 1;
    }
    return sample;
}

bool StabilityTest::look_for_end(Window& window, int limit) {
    const int origin = window.trial.origin();
    const int sign = limit < origin ? -1 : 1;
    const int furthest = std::abs(limit - origin);
    const auto is_right = [&](int steps) {
        return sample_at(window, origin + sign * steps)->right;
    };
    int right = 0;
    int wrong = furthest + 1;
    for (int steps = 1; right < furthest && wrong > furthest;
         steps = std::min(2 * steps, furthest)) {
        if (!look(window, origin + sign * steps)) return false;
        (is_right(steps) ? right : wrong) = steps;
    }
    while (wrong <= furthest && wrong - right > 1) {
        const int middle = right + (wrong - right) / 2;
        if (!look(window, origin + sign * middle)) return false;
        (is_right(middle) ? right : wrong) = middle;
    }
    return true;
}

Window StabilityTest::run(const Trial& trial) {
    Window window;
    window.trial = trial;
    bool going_on = true;
    if (trial.change == Change::extended) {
        look(window, 0);
    } else if (trial.change == Change::axes) {
        for (int k = 1; k <= 2 && going_on; ++k) going_on = look(window, k);
    } else {
        // The exponents that the user asked for come first, in case time runs out.
        for (const int k : trial.also) going_on = going_on && look(window, k);
        if (options_.every || trial.change == Change::distance)
            going_on = going_on && look(window, trial.change == Change::distance ? 0 : trial.low);
        if (options_.every) {
            for (int k = trial.low; k <= trial.high && going_on; ++k) going_on = look(window, k);
        } else {
            if (going_on && trial.low < trial.origin()) going_on = look_for_end(window, trial.low);
            if (going_on) look_for_end(window, trial.high);
        }
    }
    find_ends(window);
    return window;
}

}  // namespace lancer::judge
