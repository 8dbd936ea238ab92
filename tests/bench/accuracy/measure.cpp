#include "tests/bench/accuracy/measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/diagnostic.h"
#include "reference/pov/export.h"
#include "reference/povray/runner.h"
#include "tests/quad/renderer.h"
#include "tests/reference/tachyon/tachyon.h"
#include "tracer/render.h"

namespace lancer::bench {
namespace {

using extremes::Row;

/// A picture, or why there is none.
struct Shot {
    std::optional<Image> image;
    std::string failure;
};

double clipped(double value) {
    return std::clamp(value, 0.0, 1.0);
}

std::size_t wrong_pixels(const Image& image, const Image& truth, bool bits) {
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < truth.data.size(); i += 3) {
        bool off = false;
        for (std::size_t c = i; c < i + 3; ++c) {
            const double a = image.data[c];
            const double b = truth.data[c];
            off = off || !std::isfinite(a) ||
                  (bits ? a != b : std::abs(clipped(a) - clipped(b)) > 1.0 / 255);
        }
        wrong += off;
    }
    return wrong;
}

using Compile = std::unique_ptr<Renderer> (*)(const Scene&, const Settings&);

std::unique_ptr<Renderer> compiled(const Scene& scene, const Settings& settings) {
    return compile(scene, settings);
}

Shot by_lancer(const Scene& scene, Precision precision, Compile compiler = compiled) {
    Settings settings = scene.settings;
    settings.precision = precision;
    settings.threads = 0;
    View view;
    view.width = scene.width;
    view.height = scene.height;
    RayCounts counts;
    try {
        return {compiler(scene, settings)->render(view, {}, counts), ""};
    } catch (const SceneError& error) {
        return {std::nullopt, error.what()};
    }
}

Image filled(int width, int height, const Color& color) {
    Image image(width, height);
    for (std::size_t i = 0; i < image.data.size(); i += 3)
        for (std::size_t c = 0; c < 3; ++c) image.data[i + c] = color[static_cast<int>(c)];
    return image;
}

/// The truth for all programs at k, if the row does not compare a program with itself.
Image common_truth(const Row& row, int k) {
    if (row.formula) return row.formula(k);
    if (row.uniform) {
        const Scene scene = row.scene(k);
        return filled(scene.width, scene.height, *row.uniform);
    }
    return by_lancer(row.exactly_as(k), {}, compile_quad).image.value();
}
std::map<int, Image> common_truths(const Row& row) {
    std::map<int, Image> truths;
    for (const int k : row.ks) {
        if (row.steady && !truths.empty())
            truths.emplace(k, truths.begin()->second);
        else
            truths.emplace(k, common_truth(row, k));
    }
    return truths;
}

/// The pictures of a row in one program; `shoot` renders them.
Course run(const Row& row, const std::map<int, Image>& truths,
           const std::function<Shot(const Scene&)>& shoot) {
    Course course;
    for (const int k : row.ks) {
        const Scene scene = row.scene(k);
        const Shot shot = shoot(scene);
        const Shot own = row.same_as ? shoot(row.same_as(k)) : Shot{};
        if (shot.image && (own.image || !row.same_as)) {
            course.wrong[k] =
                wrong_pixels(*shot.image, row.same_as ? *own.image : truths.at(k), row.bits);
            continue;
        }
        course.failures[k] = shot.image ? own.failure : shot.failure;
        course.wrong[k] =
            static_cast<std::size_t>(scene.width) * static_cast<std::size_t>(scene.height);
    }
    return course;
}

/// POV-Ray starts slowly, so its pictures are collected first and made side by side.
class PovRayRun {
  public:
    explicit PovRayRun(reference::PovRay povray) : povray_(std::move(povray)) {}

    /// Registers the picture at first, and returns it once it is made. A scene is identified by its
    /// export.
    Shot shoot(const Scene& scene) {
        const reference::ExportResult exported = reference::export_pov(
            scene, {0, scene.width, scene.height}, {.name = "scene", .decades = 0});
        if (!exported.refusals.empty()) return {std::nullopt, exported.refusals.front().message};
        const auto [entry, fresh] = index_.try_emplace(exported.text, jobs_.size());
        if (fresh) {
            jobs_.push_back({"a row", exported.text, exported.assets, scene.width, scene.height});
            return {std::nullopt, "not made yet"};
        }
        if (entry->second >= outcomes_.size()) return {std::nullopt, "not made yet"};
        const reference::PovOutcome& outcome = outcomes_[entry->second];
        if (!outcome.picture) return {std::nullopt, outcome.failure};
        return {outcome.picture->image, ""};
    }

    void make(const std::function<void(const std::string&)>& say) {
        reference::PovOptions options;
        options.cache = reference::cache_folder();
        outcomes_ = reference::run_povray_jobs(povray_, jobs_, options, 0, [&](std::size_t i) {
            if (i % 50 == 0) say(fmt::format("POV-Ray: {} pictures in all", jobs_.size()));
        });
    }

  private:
    reference::PovRay povray_;
    std::vector<reference::PovJob> jobs_;
    std::map<std::string, std::size_t> index_;
    std::vector<reference::PovOutcome> outcomes_;
};

}  // namespace

const char* name_of(Program program) {
    switch (program) {
        case Program::lancer_double:
            return "double";
        case Program::lancer_single:
            return "single";
        case Program::lancer_extended:
            return "extended";
        case Program::povray:
            return "POV-Ray";
        case Program::tachyon:
            return "Tachyon";
    }
    return "";
}

Measurement measure(const std::vector<Row>& rows,
                    const std::function<void(const std::string&)>& say) {
    Measurement result;
    std::vector<std::map<int, Image>> truths;
    for (const Row& row : rows) {
        say(row.name);
        MeasuredRow measured{row, 0, {}};
        const Scene first = row.scene(row.ks.front());
        measured.pixels =
            static_cast<std::size_t>(first.width) * static_cast<std::size_t>(first.height);
        const std::map<int, Image>& truth =
            truths.emplace_back(row.same_as ? std::map<int, Image>{} : common_truths(row));
        for (const auto& [program, precision] :
             {std::pair{Program::lancer_double, Precision::double_},
              {Program::lancer_single, Precision::single},
              {Program::lancer_extended, Precision::extended}}) {
            measured.courses[program] =
                run(row, truth, [p = precision](const Scene& s) { return by_lancer(s, p); });
        }
        result.rows.push_back(std::move(measured));
    }

    try {
        const reference::PovRay povray = reference::find_povray();
        result.povray_version = povray.version;
        PovRayRun pov(povray);
        const auto shoot = [&](const Scene& scene) { return pov.shoot(scene); };
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (rows[i].povray) run(rows[i], truths[i], shoot);
        }
        pov.make(say);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            Course& course = result.rows[i].courses[Program::povray];
            if (rows[i].povray)
                course = run(rows[i], truths[i], shoot);
            else
                course.absent = "not for POV-Ray";
        }
    } catch (const FileError& error) {
        say(error.what());
    }

    const std::string tachyon = find_tachyon();
    result.tachyon = !tachyon.empty();
    for (std::size_t i = 0; i < rows.size() && result.tachyon; ++i) {
        Course& course = result.rows[i].courses[Program::tachyon];
        if (!rows[i].tachyon) {
            course.absent = "not for Tachyon";
            continue;
        }
        say("Tachyon: " + rows[i].name);
        course = run(rows[i], truths[i], [&](const Scene& scene) {
            return Shot{tachyon_picture(tachyon, scene), "Tachyon failed"};
        });
    }
    return result;
}

}  // namespace lancer::bench
