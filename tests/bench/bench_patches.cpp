// The cost and the error of tolerances: patches on their true surface and as triangles. Writes
// lines of tab-separated values; tests/bench/patches.py makes the page of them.
//
//     bench_patches SCENE.lancer [FINEST]
//
// FINEST: the smallest tolerance, 1e-6 by default. Each case runs in a process of its own, on one
// thread; times are processor time.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <random>
#include <string>

#include "cli/scene_loader.h"
#include "tracer/compile/compile.h"
#include "tracer/render.h"

namespace {

using namespace lancer;

constexpr int width = 400;
constexpr int height = 300;

double seconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec) * 1e-6;
}

/// `field` of /proc/self/status, in MB.
double memory(const std::string& field) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        if (line.rfind(field + ":", 0) == 0) return std::stod(line.substr(field.size() + 1)) / 1024;
    }
    return 0;
}

void in_a_child(const std::function<void()>& action) {
    std::fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
        action();
        std::fflush(stdout);
        _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    if (status != 0) std::exit(1);
}

Image picture(const Renderer& renderer) {
    RayCounts counts;
    return renderer.render({0, width, height, {}, false}, {}, counts);
}

double rmse(const Image& a, const Image& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.data.size(); ++i) sum += std::pow(a.data[i] - b.data[i], 2);
    return std::sqrt(sum / static_cast<double>(a.data.size()));
}

/// One row: triangles, memory, seconds to build and to trace, error.
void measure(const char* scene_name, Scene scene, std::optional<double> tolerance,
             const Image& truth) {
    in_a_child([&] {
        scene.settings.tolerance = tolerance;
        const double before = memory("VmRSS");
        const double start = seconds();
        const auto renderer = compile(scene, scene.settings);
        const Image image = picture(*renderer);
        const double both = seconds() - start;
        const double most = memory("VmHWM") - before;
        const double again = seconds();
        picture(*renderer);
        const double trace = seconds() - again;
        std::printf("case\t%s\t%g\t%llu\t%.1f\t%.3f\t%.3f\t%.3g\n", scene_name,
                    tolerance.value_or(0),
                    static_cast<unsigned long long>(renderer->counts().triangles), most,
                    std::max(0.0, both - trace), trace, rmse(image, truth));
    });
}

Image extended_picture(Scene scene) {
    scene.settings.precision = Precision::extended;
    return picture(*compile(scene, scene.settings));
}

Patch bent_patch(std::mt19937& generator, const Vec3d& at, double size) {
    std::uniform_real_distribution<double> shift(-1, 1);
    Patch patch;
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) {
            patch.control.push_back(at + Vec3d(j - 1.5 + 0.4 * shift(generator), shift(generator),
                                               i - 1.5 + 0.4 * shift(generator)) *
                                             (size / 3));
        }
    }
    return patch;
}

/// `side` x `side` bent patches of size 1 side by side, before a camera that sees
/// `seen` x `seen` of them, a light, and shadows.
Scene random_patches(int side, double seen) {
    Scene scene;
    scene.settings.threads = 1;
    std::mt19937 generator(1);
    for (int i = 0; i < side; ++i) {
        for (int j = 0; j < side; ++j) {
            Object object;
            object.shape = PatchRef{static_cast<std::uint32_t>(scene.patches.size())};
            scene.objects.push_back(object);
            scene.patches.push_back(
                bent_patch(generator, Vec3d(j - (side - 1) / 2.0, 0, i - (side - 1) / 2.0), 1));
        }
    }
    Camera camera;
    camera.position = {0, 2 * seen, 0.5 * seen};
    camera.look_at = {0, 0, 0};
    camera.projection = OrthographicProjection{0.85 * seen};
    scene.cameras.push_back(camera);
    Light light;
    light.kind = PointLight{Vec3d(0.5, 1, 0.3) * (2 * seen), {}};
    scene.lights.push_back(light);
    return scene;
}

/// 10,000 patches of which a hundred are visible: the cost of the picture when only the necessary
/// patches are cut, and the cost of cutting all of them.
void crowd(const char* name, std::optional<double> tolerance) {
    Scene scene = random_patches(100, 10);
    scene.settings.tolerance = tolerance;
    in_a_child([&] {
        const double before = memory("VmRSS");
        const double start = seconds();
        const auto renderer = compile(scene, scene.settings);
        picture(*renderer);
        std::printf("crowd\t%s\ton demand\t%.2f\t%.0f\n", name, seconds() - start,
                    memory("VmHWM") - before);
    });
    in_a_child([&] {
        const double before = memory("VmRSS");
        const double start = seconds();
        const auto world = compile_world<double>(scene, scene.settings);
        for (const auto& patch : world->patches) patch->mesh();
        for (const auto& patch : world->bicubics) patch->tree();
        std::printf("crowd\t%s\tcutting all\t%.2f\t%.0f\n", name, seconds() - start,
                    memory("VmHWM") - before);
    });
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) return 2;
    const double finest = argc > 2 ? std::atof(argv[2]) : 1e-6;
    cli::Session session;
    Scene teapot = cli::SceneLoader(argv[1], {}, session).load();
    teapot.settings.threads = 1;
    teapot.settings.samples = 1;
    const Scene random = random_patches(4, 4);
    const std::pair<const char*, const Scene&> subjects[] = {{"teapot", teapot},
                                                             {"random", random}};
    for (const auto& [name, scene] : subjects) {
        const Image truth = extended_picture(scene);
        measure(name, scene, {}, truth);
        for (int k = 1; k <= 6; ++k) {
            const double tolerance = std::stod("1e-" + std::to_string(k));
            if (tolerance >= finest * 0.99) measure(name, scene, tolerance, truth);
        }
    }
    crowd("true surface", {});
    crowd("triangles, 1e-3", 1e-3);
}
