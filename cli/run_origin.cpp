#include "cli/run_origin.h"

#include <fmt/format.h>

#include <type_traits>

#include "cli/build_identity.h"
#include "model/precision_names.h"

namespace lancer::cli {
namespace {

std::string text_of(const ErrorOptions& e) {
    std::string text;
    if (e.max_error) text += fmt::format(", error {}", *e.max_error);
    if (e.max_off) text += fmt::format(", off {}:{}", e.max_off->share, e.max_off->steps);
    if (e.seconds) text += fmt::format(", time {}", *e.seconds);
    if (e.passes) text += fmt::format(", passes {}", *e.passes);
    if (e.no_audit) text += ", no audit";
    return text;
}

}  // namespace

std::string text_of(const Settings& s) {
    static_assert(sizeof(Settings) == 64, "a setting was added: tell it here");
    return fmt::format(
        "samples {} {}, seed {}, depth {}, contribution {}, precision {}, tolerance {}{}{}{}",
        s.samples, s.sampling == Sampling::sobol ? "sobol" : "grid", s.seed, s.max_depth,
        s.min_contribution, name_of(s.precision),
        s.tolerance ? fmt::format("{}", *s.tolerance) : "none", s.shadows ? "" : ", no shadows",
        s.smooth ? "" : ", not smooth", s.textures ? "" : ", no textures");
}

io::Origin origin_of(const RenderJob& job, SceneLoader& loader, const Scene& scene,
                     const Settings& settings, const View& view, double frame, double time) {
    std::string options = fmt::format("size {}x{}", view.width, view.height);
    if (view.crop) {
        const Crop& c = *view.crop;
        options += fmt::format(", crop {},{},{},{}", c.x, c.y, c.width, c.height);
    }
    options += fmt::format(", camera {}", view.camera);
    if (job.frames) options += fmt::format(", frame {}, time {}", frame, time);
    options += ", " + text_of(settings) + text_of(job.error);
    if (view.aov) options += ", aov";
    if (view.alpha) options += ", alpha";
    if (job.image.bits != 8) options += fmt::format(", bits {}", job.image.bits);
    if (job.image.linear) options += ", linear";
    return {loader.digest_of(scene), std::string(build_identity()), options};
}

}  // namespace lancer::cli
