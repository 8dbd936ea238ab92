#include "cli/scene_loader.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <functional>
#include <string_view>

#include "base/sha256.h"
#include "cli/arguments.h"
#include "cli/deep_stack.h"
#include "cli/picture_options.h"
#include "cli/scene_digest.h"
#include "cli/stopwatch.h"
#include "model/io/file.h"

namespace lancer::cli {
namespace {

/// More than any limit on scripts, and small enough that reading /dev/zero does not fill the
/// memory.
std::size_t most_bytes_read(const Limits& limits) {
    constexpr std::uint64_t least = std::uint64_t(1) << 30;
    return static_cast<std::size_t>(std::max(least, limits.source_bytes + 1));
}

std::string without_blanks(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string::npos) return "";
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// Reads from disk, and calls `note` with the path of each file.
Loader noting_loader(int threads, const std::function<void(const std::string& path)>& note) {
    const Loader disk = disk_loader(threads);
    return {[note, disk](const std::string& path, std::size_t limit) {
                note(path);
                return disk.text(path, limit);
            },
            [note, disk](const std::string& path) {
                note(path);
                return disk.mesh(path);
            },
            [note, disk](const std::string& path, io::ColorSpace space) {
                note(path);
                return disk.image(path, space);
            }};
}

void add_limit(CLI::App& app, const std::string& name, std::uint64_t& target, std::int64_t most,
               const std::string& what) {
    app.add_option_function<std::string>(
           "--limit-" + name,
           [&target, name, most](const std::string& text) {
               const std::int64_t value = parse_whole_number(text);
               if (value < 1 || value > most) {
                   throw UsageError(fmt::format("--limit-{} must be between 1 and {}", name, most));
               }
               target = static_cast<std::uint64_t>(value);
           },
           fmt::format("{} (default {})", what, target))
        ->type_name("N")
        ->group("Limits");
}

}  // namespace

void add_scene_options(CLI::App& app, SceneOptions& options) {
    app.add_option_function<std::vector<std::string>>(
           "-D",
           [&options](const std::vector<std::string>& texts) {
               for (const std::string& text : texts) {
                   const std::size_t equals = std::min(text.find('='), text.size());
                   const std::string name = without_blanks(text.substr(0, equals));
                   const std::string value =
                       without_blanks(text.substr(std::min(equals + 1, text.size())));
                   if (name.empty() || value.empty()) {
                       throw UsageError(
                           fmt::format("-D '{}': expected name=value, as in -D level=5", text));
                   }
                   options.definitions.emplace_back(name, value);
               }
           },
           "Give a param of the script another value; can be repeated")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);

    constexpr std::int64_t most = 1'000'000'000'000;
    constexpr std::int64_t deepest = 1'000'000;
    Limits& limits = options.limits;
    add_limit(app, "statements", limits.statements, most, "Statements executed");
    add_limit(app, "calls", limits.calls, deepest, "Nested calls and includes");
    add_limit(app, "nesting", limits.nesting, deepest, "Levels of nesting in the text");
    add_limit(app, "source-bytes", limits.source_bytes, std::int64_t(1) << 32,
              "Bytes of all source files");
    add_limit(app, "list-elements", limits.list_elements, most, "List elements created in total");
    add_limit(app, "objects", limits.objects, 4'000'000'000, "Objects of the scene");
    add_picture_options(app);
}

SceneLoader::SceneLoader(const std::string& path, const SceneOptions& options, Session& session,
                         int threads)
    : options_(options), session_(session), threads_(threads) {
    const Stopwatch watch;
    session.files.add_input(path);
    std::string text = io::read_file(path, most_bytes_read(options.limits));
    run_on_deep_stack(options_.limits, [&] {
        script_ =
            parse_script(path, std::move(text), options_.limits, session_.sources, syntax_errors_);
    });
    parse_seconds_ = watch.seconds();
}

Scene SceneLoader::load(std::optional<double> frame, std::optional<double> time) {
    const Stopwatch watch;
    const Definitions definitions{options_.definitions, frame, time};
    const auto note = [this](const std::string& path) {
        session_.files.add_input(path);
        read_.try_emplace(path);
    };
    std::vector<Diagnostic> found = syntax_errors_;
    Evaluation evaluation;
    run_on_deep_stack(options_.limits, [&] {
        evaluation = evaluate(script_, definitions, options_.limits, session_.sources, found,
                              noting_loader(threads_, note));
    });
    evaluate_seconds_ += watch.seconds();

    session_.terminal.lines(evaluation.printed);
    // A wrong -D causes further errors in the scene, so it is reported alone. But after a syntax
    // error, it may be wrong only because the declaration of its param could not be parsed.
    if (!evaluation.usage_errors.empty() && syntax_errors_.empty()) {
        const Diagnostic& first = evaluation.usage_errors.front();
        // The text of `-D name=value` is a source called `-D name`.
        const bool in_value = first.where.file != SourceSpan::nowhere;
        throw UsageError(fmt::format("{}{}{}{}",
                                     in_value ? session_.sources.name(first.where.file) + ": " : "",
                                     first.message, first.hint.empty() ? "" : ": ", first.hint));
    }
    const bool is_right = std::none_of(found.begin(), found.end(), [](const Diagnostic& d) {
        return d.severity == Severity::error;
    });
    if (hints_ && is_right)
        for (Diagnostic& hint : hints_(evaluation.scene)) found.push_back(std::move(hint));
    show_new(std::move(found));
    return std::move(evaluation.scene);
}

Scene SceneLoader::load_last(std::optional<double> frame, std::optional<double> time) {
    Scene scene = load(frame, time);
    script_.forget();
    return scene;
}

std::string SceneLoader::content() {
    std::string all = framed(session_.sources.text(script_.file));
    for (const auto& [name, value] : options_.definitions) all += framed(name) + framed(value);
    for (const auto& [path, digest] : read_) all += framed(file_digest(path));
    return sha256(all);
}

std::string SceneLoader::digest_of(const Scene& scene) {
    return scene_digest(scene, [this](const std::string& path) { return file_digest(path); });
}

const std::string& SceneLoader::file_digest(const std::string& path) {
    std::string& digest = read_[path];
    if (digest.empty()) digest = sha256(io::read_file(path));
    return digest;
}

void SceneLoader::show_new(std::vector<Diagnostic> found) {
    std::erase_if(found, [this](const Diagnostic& diagnostic) {
        return diagnostic.severity == Severity::warning &&
               !shown_.insert(format(diagnostic, session_.sources)).second;
    });
    // The text of `-D name=value` is a source called `-D name`.
    const bool is_wrong_use = std::any_of(found.begin(), found.end(), [this](const Diagnostic& d) {
        return d.severity == Severity::error && d.where.file != SourceSpan::nowhere &&
               session_.sources.name(d.where.file).starts_with("-D ");
    });
    if (session_.terminal.show(std::move(found), session_.sources) > 0)
        throw SceneRejected(is_wrong_use ? ExitCode::usage : ExitCode::scene);
}

std::size_t pick_camera(const Scene& scene, const std::string& name, const Session& session) {
    if (scene.cameras.empty()) {
        Diagnostic missing = missing_parts(scene).front();
        missing.severity = Severity::error;
        session.terminal.show({missing}, session.sources);
        throw SceneRejected(ExitCode::scene);
    }
    if (name.empty()) return 0;
    std::string names;
    for (std::size_t i = 0; i < scene.cameras.size(); ++i) {
        if (scene.cameras[i].name == name) return i;
        names += (i > 0 ? ", " : "") + scene.cameras[i].name;
    }
    throw UsageError(
        fmt::format("--camera: the scene has no camera '{}'; it has: {}", name, names));
}

std::vector<Diagnostic> missing_parts(const Scene& scene) {
    std::vector<Diagnostic> found;
    const auto warn = [&found](const char* message, const char* hint) {
        found.push_back({Severity::warning, {}, message, hint, {}});
    };
    if (scene.cameras.empty()) {
        warn("the scene has no camera, so it cannot be rendered",
             "camera front { position [0, 1, 5] look_at [0, 0, 0] }");
    }
    if (scene.lights.empty()) {
        warn("the scene has no light: only ambient light and emission are visible",
             "light point { position [4, 6, 3] }");
    }
    return found;
}

}  // namespace lancer::cli
