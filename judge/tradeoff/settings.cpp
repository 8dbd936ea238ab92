#include "judge/tradeoff/settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "judge/report/html.h"
#include "model/elementary.h"
#include "model/precision_names.h"
#include "model/quality.h"

namespace lancer::judge {
namespace {

// With the depth of `exact` this is fine enough for a tenth of any error that is measured here,
// except where mirrors keep light for ever. The report states the bound (accuracy/cut_bound.h).
constexpr double least_contribution = 1e-7;
constexpr int base_samples = 3;

/// The size of a pixel at the camera's look_at point.
double pixel_size(const Camera& camera, int height) {
    if (const auto* flat = std::get_if<OrthographicProjection>(&camera.projection))
        return flat->height / height;
    const double fov = std::get<PerspectiveProjection>(camera.projection).fov;
    const double half = elementary::tan(fov / 2 * 3.14159265358979323846 / 180);
    return 2 * half * length(camera.look_at - camera.position) / height;
}

/// The shortest text that people would type.
std::string typed(double value) {
    return shown(value, 3);
}

/// The value that parsing its typed text gives.
double as_typed(double value) {
    const std::string text = typed(value);
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

class Namer {
  public:
    void add(const std::string& label, const std::string& option) {
        if (!label.empty()) label_ += (label_.empty() ? "" : ", ") + label;
        if (!option.empty()) options_ += (options_.empty() ? "" : " ") + option;
    }
    std::string label_;
    std::string options_;
};

}  // namespace

const char* name_of(Knob knob) {
    switch (knob) {
        case Knob::scene:
            return "scene";
        case Knob::exact:
            return "exact";
        case Knob::quality:
            return "quality";
        case Knob::samples:
            return "samples";
        case Knob::max_depth:
            return "max-depth";
        case Knob::min_contribution:
            return "min-contribution";
        case Knob::tolerance:
            return "tolerance";
        case Knob::precision:
            return "precision";
        case Knob::shadows:
            return "shadows";
        case Knob::smooth:
            return "smooth";
        case Knob::textures:
            return "textures";
        case Knob::max_error:
            return "max-error";
        case Knob::combination:
            return "combination";
    }
    return "";
}

bool TurnedScene::recurses() const {
    return requirements.needs(Feature::reflection) || requirements.needs(Feature::transmission);
}

TurnedScene turned(const Scene& scene, const View& view) {
    Settings uncut = scene.settings;
    uncut.max_depth = std::max(values_of(Quality::exact).max_depth, uncut.max_depth);
    uncut.min_contribution = std::min(least_contribution, uncut.min_contribution);
    uncut.precision = Precision::double_;
    const double pixel = pixel_size(scene.cameras[view.camera], view.height);
    return {scene, requirements_of(scene, uncut), pixel, uncut};
}

TradeSetting named(const TurnedScene& turned, TradeSetting setting) {
    const Settings& own = turned.scene.settings;
    const Settings& s = setting.settings;
    Namer name;
    if (setting.max_error) {
        name.add("error " + typed(*setting.max_error), "--max-error " + typed(*setting.max_error));
        if (!setting.audited) name.add("no audit", "--no-audit");
    } else {
        const bool grid = s.sampling == Sampling::grid;
        name.add(fmt::format("{} {} x {}", grid ? "grid" : "sobol", s.samples, s.samples),
                 s.sampling == own.sampling ? ""
                 : grid                     ? "--sampling grid"
                                            : "--sampling sobol");
        name.add("", fmt::format("--samples {}", s.samples));
    }
    if (turned.recurses() && !setting.max_error) {
        const bool is_cut = s.max_depth != turned.uncut.max_depth;
        name.add(is_cut ? fmt::format("depth {}", s.max_depth) : "",
                 fmt::format("--max-depth {}", s.max_depth));
        const bool is_coarse = s.min_contribution != turned.uncut.min_contribution;
        name.add(is_coarse ? "contribution " + typed(s.min_contribution) : "",
                 "--min-contribution " + typed(s.min_contribution));
    }
    if (s.tolerance != own.tolerance && s.tolerance)
        name.add("tolerance " + typed(*s.tolerance), "--tolerance " + typed(*s.tolerance));
    const std::string precision(name_of(s.precision));
    name.add(s.precision == Precision::double_ ? "" : precision,
             s.precision == own.precision ? "" : "--precision " + precision);
    if (s.shadows != own.shadows) name.add("no shadows", "--no-shadows");
    if (s.smooth != own.smooth) name.add("no smooth", "--no-smooth");
    if (s.textures != own.textures) name.add("no textures", "--no-textures");
    setting.label = name.label_;
    setting.options = name.options_;
    return setting;
}

TradeSetting own_setting(const TurnedScene& turned) {
    TradeSetting setting{Knob::scene, turned.scene.settings, {}, true, "", ""};
    setting.label = "as the scene says";
    return setting;
}

std::vector<TradeSetting> quality_settings(const TurnedScene& turned, int most_samples) {
    std::vector<TradeSetting> all;
    for (const Quality quality : all_qualities) {
        const QualityValues& values = values_of(quality);
        if (values.samples > most_samples || quality == Quality::exact) continue;
        TradeSetting setting{Knob::quality, turned.uncut, {}, true, "", ""};
        apply(values, setting.settings);
        setting.settings.precision = turned.scene.settings.precision;
        setting.label = "quality " + std::string(name_of(quality));
        setting.options = "--quality " + std::string(name_of(quality));
        all.push_back(setting);
    }
    return all;
}

TradeSetting exact_setting(const TurnedScene& turned, int samples) {
    TradeSetting setting{Knob::exact, turned.uncut, {}, true, "", ""};
    setting.settings.sampling = Sampling::sobol;
    setting.settings.samples = samples;
    setting = named(turned, setting);
    setting.label = "exact: " + setting.label;
    return setting;
}

TradeSetting base_setting(const TurnedScene& turned, int most_samples) {
    TradeSetting setting = exact_setting(turned, std::min(base_samples, most_samples));
    setting.knob = Knob::samples;
    return named(turned, setting);
}

std::vector<TradeSetting> single_settings(const TurnedScene& turned, int most_samples) {
    std::vector<TradeSetting> all;
    const TradeSetting base = base_setting(turned, most_samples);
    const auto add = [&](Knob knob, const auto& change) {
        TradeSetting setting = base;
        setting.knob = knob;
        change(setting);
        all.push_back(named(turned, setting));
    };
    for (const Sampling sampling : {Sampling::grid, Sampling::sobol}) {
        for (const int n : {1, 2, 3, 4, 6, 8}) {
            if (sampling == Sampling::sobol && (n == 1 || n >= most_samples)) continue;
            if (n > most_samples) continue;
            add(Knob::samples, [&](TradeSetting& s) {
                s.settings.sampling = sampling;
                s.settings.samples = n;
            });
        }
    }
    if (turned.recurses()) {
        for (const int depth : {1, 2, 3, 4, 5, 6, 8, 12, 16, 24, 32})
            add(Knob::max_depth, [&](TradeSetting& s) { s.settings.max_depth = depth; });
        for (const double least : {0.1, 0.03, 0.01, 0.003, 0.001, 0.0003})
            add(Knob::min_contribution,
                [&](TradeSetting& s) { s.settings.min_contribution = least; });
    }
    if (turned.has_splines()) {
        for (const double pixels : {4.0, 1.0, 0.25, 0.0625})
            add(Knob::tolerance,
                [&](TradeSetting& s) { s.settings.tolerance = as_typed(pixels * turned.pixel); });
    }
    for (const Precision precision : {Precision::single, Precision::extended})
        add(Knob::precision, [&](TradeSetting& s) { s.settings.precision = precision; });
    if (turned.requirements.needs(Feature::shadows))
        add(Knob::shadows, [](TradeSetting& s) { s.settings.shadows = false; });
    if (turned.requirements.needs(Feature::smooth_normals))
        add(Knob::smooth, [](TradeSetting& s) { s.settings.smooth = false; });
    if (turned.requirements.needs(Feature::textures))
        add(Knob::textures, [](TradeSetting& s) { s.settings.textures = false; });
    for (const bool audited : {true, false}) {
        for (const double error : {0.02, 0.01, 0.005, least_asked_error}) {
            add(Knob::max_error, [&](TradeSetting& s) {
                s.max_error = error;
                s.audited = audited;
            });
        }
    }
    // If time runs out, the most expensive settings are dropped: so order by cost, keeping the
    // order of each knob's settings.
    std::stable_sort(all.begin(), all.end(), [](const TradeSetting& a, const TradeSetting& b) {
        const auto order = [](const TradeSetting& s) {
            return s.max_error ? 1e9 / *s.max_error : s.points();
        };
        return order(a) < order(b);
    });
    return all;
}

void take_knob(const TradeSetting& from, Settings& to) {
    const Settings& s = from.settings;
    switch (from.knob) {
        case Knob::max_depth:
            to.max_depth = s.max_depth;
            break;
        case Knob::min_contribution:
            to.min_contribution = s.min_contribution;
            break;
        case Knob::tolerance:
            to.tolerance = s.tolerance;
            break;
        case Knob::precision:
            to.precision = s.precision;
            break;
        case Knob::shadows:
            to.shadows = s.shadows;
            break;
        case Knob::smooth:
            to.smooth = s.smooth;
            break;
        case Knob::textures:
            to.textures = s.textures;
            break;
        default:
            to.samples = s.samples;
            to.sampling = s.sampling;
    }
}

}  // namespace lancer::judge
