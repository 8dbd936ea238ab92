// lancer pack
#include "judge/pack/pack.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/scene_loader.h"
#include "cli/scene_size.h"
#include "cli/scene_words.h"
#include "cli/stopwatch.h"
#include "model/io/file.h"

namespace lancer::cli {
namespace {

namespace fs = std::filesystem;

struct PackJob {
    std::vector<std::string> scenes;
    std::string output;
    std::string camera;
    std::optional<PictureSize> size;
    std::optional<std::int64_t> probes;
    bool quiet = false;
    SceneOptions scene_options;
};

/// The name of each scene's folder: the name of its file, preceded by its parent folder's name
/// where two files have the same name.
std::vector<std::string> names_of(const std::vector<std::string>& scenes) {
    std::vector<std::string> names;
    std::multiset<std::string> stems;
    const auto stem = [](const std::string& path) {
        return path == "-" ? "scene" : fs::path(path).stem().string();
    };
    for (const std::string& path : scenes) stems.insert(stem(path));
    for (const std::string& path : scenes) {
        const std::string folder = fs::path(path).parent_path().filename().string();
        const bool alone = stems.count(stem(path)) == 1 || folder.empty();
        names.push_back(alone ? stem(path) : folder + "-" + stem(path));
        if (std::count(names.begin(), names.end(), names.back()) > 1)
            throw UsageError(fmt::format("two of the scenes would have the name '{}' in the pack",
                                         names.back()));
    }
    return names;
}

/// Refuses a folder that holds other files than a pack.
void check_folder(const std::string& folder) {
    std::error_code ignored;
    if (!fs::exists(folder, ignored)) return;
    if (!fs::is_directory(folder, ignored))
        throw UsageError(fmt::format("'{}' is a file, but a pack is a folder", folder));
    const std::string index = folder + "/pack.json";
    if (fs::exists(index, ignored) && judge::is_pack_index(io::read_file(index, 1 << 24))) return;
    if (!fs::is_empty(folder, ignored)) {
        throw UsageError(fmt::format(
            "'{}' contains files that are not an earlier pack: choose a new folder", folder));
    }
}

class Packer {
  public:
    Packer(const PackJob& job, Session& session) : job_(job), session_(session) {}

    ExitCode run() {
        const std::vector<std::string> names = names_of(job_.scenes);
        check_folder(job_.output);
        session_.files.add_output_in_new_folder(job_.output + "/pack.json", "-o");
        session_.files.add_output_in_new_folder(job_.output + "/README.md", "-o");
        const Stopwatch watch;
        std::vector<std::string> packed;
        std::vector<std::string> left_out;
        for (std::size_t i = 0; i < names.size(); ++i) {
            const bool is_packed = pack(job_.scenes[i], names[i]);
            (is_packed ? packed : left_out).push_back(is_packed ? names[i] : job_.scenes[i]);
        }
        if (!packed.empty()) {
            write("README.md", judge::pack_readme());
            write("pack.json", judge::pack_index(packed, LANCER_VERSION));
        }
        if (!job_.quiet) tell(packed.size(), left_out, watch.seconds());
        return worst_;
    }

  private:
    void write(const std::string& name, const std::string& bytes) {
        io::write_file(job_.output + "/" + name, bytes);
        bytes_ += bytes.size();
    }

    void tell(std::size_t packed, const std::vector<std::string>& left_out, double seconds) {
        if (packed > 0)
            session_.output.say(
                fmt::format("wrote {}: {} scene{}, {:.1f} MB in {:.1f} s, see "
                            "{}/README.md\n",
                            job_.output, packed, packed == 1 ? "" : "s",
                            static_cast<double>(bytes_) / 1e6, seconds, job_.output));
        if (!left_out.empty() && packed + left_out.size() > 1)
            session_.output.say(fmt::format("{} of {} scenes were left out: {}\n", left_out.size(),
                                            packed + left_out.size(), fmt::join(left_out, ", ")));
    }

    judge::ValidationJob load(const std::string& path, const std::string& name) {
        SceneLoader loader(path, job_.scene_options, session_);
        auto scene = std::make_shared<Scene>(loader.load());
        judge::prepare_for_validation(*scene);
        const PictureSize size = size_or(job_.size, *scene, 320);
        judge::ValidationJob result;
        result.name = name;
        result.path = path;
        result.place_text = [&sources = session_.sources](const SourceSpan& span) {
            return describe_place(span, sources);
        };
        result.view = {static_cast<std::uint32_t>(pick_camera(*scene, job_.camera, session_)),
                       size.width, size.height};
        result.scene = std::move(scene);
        return result;
    }

    /// False when the scene is left out; the other scenes are still packed.
    bool pack(const std::string& path, const std::string& name) {
        try {
            const auto probes = static_cast<std::size_t>(
                job_.probes.value_or(static_cast<std::int64_t>(judge::default_probes)));
            const judge::Pack pack = judge::pack_scene(load(path, name), probes);
            session_.terminal.show(pack.warnings, session_.sources);
            for (const judge::PackedFile& file : pack.files)
                session_.files.add_output_in_new_folder(
                    fmt::format("{}/{}/{}", job_.output, name, file.name), "-o");
            fs::create_directories(fs::path(job_.output) / name);
            for (const judge::PackedFile& file : pack.files)
                write(name + "/" + file.name, file.bytes);
            if (!job_.quiet)
                session_.output.say(fmt::format("{}: {} probes, {} pixels undecided\n", name,
                                                pack.probes, pack.undecided));
            return true;
        } catch (const SceneRejected& rejected) {
            worst_ = std::max(worst_, rejected.code);
        } catch (const SceneError& error) {
            session_.terminal.error(path + ": " + error.what());
            worst_ = std::max(worst_, ExitCode::scene);
        } catch (const FileError& error) {
            session_.terminal.error(error.what());
            worst_ = std::max(worst_, ExitCode::files);
        }
        return false;
    }

    const PackJob& job_;
    Session& session_;
    ExitCode worst_ = ExitCode::done;
    std::uintmax_t bytes_ = 0;  ///< written
};

}  // namespace

void add_pack(CLI::App& app, Action& action) {
    CLI::App& command =
        *app.add_subcommand("pack", "Write what another renderer needs to test itself on scenes");
    const auto job = std::make_shared<PackJob>();
    command.add_option("SCENE", job->scenes, "Scene files")->required()->type_name("");
    command
        .add_option("-o,--output", job->output, "A new folder, or the folder of an earlier pack")
        ->required()
        ->type_name("DIR");
    command.add_option("--camera", job->camera, "Name of the camera; by default the first one")
        ->type_name("NAME");
    command
        .add_option_function<std::string>(
            "--size", [job](const std::string& text) { job->size = parse_size(text); },
            "Size of the pictures; by default 320 pixels wide, in the scene's proportions")
        ->type_name("WxH");
    add_whole_number(command, "--probes", job->probes, 0, 100'000,
                     "Pixels with exact values (default 32)")
        ->type_name("N");
    command.add_flag("-q,--quiet", job->quiet,
                     "Print nothing: only the exit code tells the result");
    add_scene_options(command, job->scene_options);
    command.footer(
        "Examples:"
        "\n  lancer pack scene.lancer -o pack");
    command.callback([&action, job] {
        action = [job](Session& session) { return Packer(*job, session).run(); };
    });
}

}  // namespace lancer::cli
