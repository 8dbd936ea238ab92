// What accuracy costs: the tracer beside itself with textbook formulas and an epsilon.
//
//     bench_kernels                     time ratios of all scenes and sets, as JSON
//     bench_kernels SET SCENE [WIDTH]   one picture, for counting instructions
//
// tests/bench/kernels/kernels.py runs both and writes the table in docs/performance.md.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "model/io/file.h"
#include "parser/parse.h"
#include "tests/bench/kernels/kernel_sets.h"

namespace {

using namespace lancer;

struct KernelSet {
    const char* name;
    std::unique_ptr<Renderer> (*compile)(const Scene&, const Settings&);
};
constexpr KernelSet sets[] = {
    {"own", compile_set<0>},    {"shapes", compile_set<1>},   {"tree", compile_set<2>},
    {"places", compile_set<4>}, {"contacts", compile_set<8>}, {"all", compile_set<15>},
};
constexpr const char* scenes[] = {"spheres", "boxes",   "planes", "triangles",
                                  "frusta",  "harbour", "glass"};
constexpr int rounds = 31;

std::string path_of(const std::string& scene) {
    const std::string root = LANCER_SOURCE_DIR;
    return scene == "harbour" ? root + "/scenes/gallery/harbour.lancer"
                              : root + "/tests/bench/kernels/scenes/" + scene + ".lancer";
}

Scene load(const std::string& name, Settings& settings) {
    SourceMap sources;
    std::vector<Diagnostic> found;
    const std::string path = path_of(name);
    const Script script = parse_script(path, io::read_file(path, 1 << 20), {}, sources, found);
    Evaluation evaluation = evaluate(script, {}, {}, sources, found);
    for (const Diagnostic& d : found) {
        if (d.severity == Severity::error) throw std::runtime_error(name + ": " + d.message);
    }
    settings = evaluation.scene.settings;
    settings.samples = 1;
    settings.threads = 1;
    return std::move(evaluation.scene);
}

View view_of(int width) {
    View view;
    view.width = width;
    view.height = width * 3 / 4;
    return view;
}

/// Seconds of processor time, which other processes influence less than wall-clock time.
double seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Share of pixels that differ by more than 1/255.
double different(const Image& a, const Image& b) {
    int count = 0;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            bool differs = false;
            for (int c = 0; c < 3; ++c)
                differs |= std::abs(a.pixel(x, y)[c] - b.pixel(x, y)[c]) > 1.0 / 255;
            count += differs;
        }
    }
    return static_cast<double>(count) / a.width / a.height;
}

/// Renders the scene with every set in turn, `rounds` times. Returns the median over the rounds of
/// the tracer's time divided by the set's time.
nlohmann::json measure(const std::string& name) {
    Settings settings;
    const Scene scene = load(name, settings);
    std::vector<std::unique_ptr<Renderer>> renderers;
    std::vector<Image> pictures;
    for (const KernelSet& set : sets) renderers.push_back(set.compile(scene, settings));
    std::vector<std::vector<double>> times(std::size(sets));
    for (int round = 0; round <= rounds; ++round) {
        for (std::size_t i = 0; i < std::size(sets); ++i) {
            RayCounts counts;
            const double begin = seconds();
            Image picture = renderers[i]->render(view_of(320), {}, counts);
            if (round > 0)
                times[i].push_back(seconds() - begin);
            else
                pictures.push_back(std::move(picture));
        }
    }
    nlohmann::json row;
    for (std::size_t i = 0; i < std::size(sets); ++i) {
        std::vector<double> ratios;
        for (std::size_t r = 0; r < rounds; ++r) ratios.push_back(times[0][r] / times[i][r]);
        std::nth_element(ratios.begin(), ratios.begin() + rounds / 2, ratios.end());
        row[sets[i].name] = {{"ratio", ratios[rounds / 2]},
                             {"seconds", *std::min_element(times[i].begin(), times[i].end())},
                             {"different", different(pictures[0], pictures[i])}};
    }
    return row;
}

void render_once(const std::string& set_name, const std::string& scene_name, int width) {
    Settings settings;
    const Scene scene = load(scene_name, settings);
    for (const KernelSet& set : sets) {
        if (set_name != set.name) continue;
        RayCounts counts;
        set.compile(scene, settings)->render(view_of(width), {}, counts);
        return;
    }
    throw std::runtime_error("no such set: " + set_name);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        if (argc > 2) {
            render_once(argv[1], argv[2], argc > 3 ? std::atoi(argv[3]) : 320);
            return 0;
        }
        nlohmann::json table;
        for (const char* scene : scenes) {
            if (argc > 1 && std::string(argv[1]) != scene) continue;
            table[scene] = measure(scene);
        }
        std::puts(table.dump(2).c_str());
        return 0;
    } catch (const std::exception& failure) {
        std::fprintf(stderr, "%s\n", failure.what());
        return 1;
    }
}
