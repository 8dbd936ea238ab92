#include "reference/povray/runner.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <mutex>
#include <sstream>
#include <thread>

#include "base/parallel.h"
#include "model/diagnostic.h"
#include "model/io/png_file.h"
#include "model/io/temporary_file.h"
#include "reference/povray/cache.h"
#include "reference/povray/process.h"

namespace lancer::reference {

namespace fs = std::filesystem;

namespace {

bool is_program(const fs::path& path) {
    std::error_code error;
    return fs::is_regular_file(path, error) && ::access(path.c_str(), X_OK) == 0;
}

std::string program_in_path() {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (!folder.empty() && is_program(fs::path(folder) / "povray"))
            return (fs::path(folder) / "povray").string();
    throw FileError(
        "POV-Ray was not found: LANCER_POVRAY is not set and there is no 'povray' in PATH "
        "(Debian: apt-get install povray)");
}

std::string program_to_use() {
    const char* named = std::getenv("LANCER_POVRAY");
    if (!named || !*named) return program_in_path();
    if (!is_program(named))
        throw FileError(fmt::format("LANCER_POVRAY is set to '{}', which is not a program", named));
    return fs::absolute(named).string();
}

/// POV-Ray's errors or warnings from its output. Continuation lines of a long message begin with a
/// space.
std::vector<std::string> lines_with(const std::string& messages, std::string_view word) {
    std::vector<std::string> out;
    bool going_on = false;
    std::istringstream lines(messages);
    for (std::string line; std::getline(lines, line);) {
        if (going_on && line.starts_with(' ')) {
            out.back() += line;
            continue;
        }
        going_on = line.find(word) != std::string::npos;
        if (going_on) out.push_back(line);
    }
    return out;
}

std::string error_lines(const ProcessResult& result) {
    std::vector<std::string> lines = lines_with(result.messages, "rror");
    if (lines.empty()) {  // no line looks like an error: use the last lines
        std::istringstream all(result.messages);
        for (std::string line; std::getline(all, line);)
            if (!line.empty()) lines.push_back(line);
        if (lines.size() > 3) lines.erase(lines.begin(), lines.end() - 3);
    }
    std::string out;
    for (const std::string& line : lines) out += "\n    " + line;
    return out;
}

void write_bytes(const fs::path& path, const std::string& bytes) {
    std::ofstream file(path, std::ios::binary);
    file << bytes;
    file.close();
    if (!file) throw FileError("cannot write '" + path.string() + "'");
}

/// The 25th byte of a PNG is its number of bits per value (ISO/IEC 15948, 11.2.2).
int png_bits(const std::string& png) {
    return png.size() > 24 ? png[24] : 0;
}

Image to_image(const std::string& png, const PovJob& job) {
    // Decodes the values as linear light, which POV-Ray was told to write.
    Image image = io::decode_png(png, "POV-Ray's picture of " + job.name, io::ColorSpace::linear);
    if (image.width != job.width || image.height != job.height || png_bits(png) != 16 ||
        image.channels != 3)
        throw FileError(
            fmt::format("POV-Ray's picture of '{}' is {} x {} with {} channels of {} bits, not {} "
                        "x {} with 3 of 16",
                        job.name, image.width, image.height, image.channels, png_bits(png),
                        job.width, job.height));
    return image;
}

std::string joined(const std::string& program, const std::vector<std::string>& arguments) {
    std::string out = program;
    for (const std::string& argument : arguments) out += " " + argument;
    return out;
}

/// Renders in a temporary folder and returns the bytes of the PNG.
std::string render(const PovRay& povray, const PovJob& job, const PovOptions& options,
                   PovPicture& picture) {
    const io::TemporaryFolder folder;
    write_bytes(folder.path() / "scene.pov", job.text);
    for (const Asset& asset : job.assets) write_bytes(folder.path() / asset.name, asset.bytes);
    std::vector<std::string> command = povray_arguments(job.width, job.height, options.threads);
    command.insert(command.begin(), povray.program);
    const ProcessResult result = run_process(command, folder.path(), options.time_limit);
    if (result.timed_out)
        throw FileError(fmt::format("POV-Ray did not finish '{}' within {} s and was stopped",
                                    job.name, options.time_limit));
    if (result.exit_code != 0)
        throw FileError(fmt::format("POV-Ray failed on '{}' (exit code {}):{}", job.name,
                                    result.exit_code, error_lines(result)));
    picture.seconds = result.seconds;
    picture.warnings = lines_with(result.messages, "arning:");
    std::ifstream file(folder.path() / "scene.png", std::ios::binary);
    std::string png{std::istreambuf_iterator<char>(file), {}};
    if (png.empty())
        throw FileError("POV-Ray wrote no picture of '" + job.name + "'" + error_lines(result));
    return png;
}

}  // namespace

PovRay find_povray() {
    PovRay povray{program_to_use(), ""};
    const io::TemporaryFolder folder;
    const ProcessResult result = run_process({povray.program, "--version"}, folder.path(), 20);
    if (result.timed_out)
        throw FileError("'" + povray.program + " --version' did not answer within 20 s");
    static constexpr std::string_view name = "POV-Ray ";
    const std::size_t at = result.messages.find(name);
    if (at == std::string::npos)
        throw FileError("'" + povray.program +
                        "' does not say that it is POV-Ray:" + error_lines(result));
    const std::size_t start = at + name.size();
    povray.version =
        result.messages.substr(start, result.messages.find_first_of(" \r\n", start) - start);
    if (!povray.version.starts_with("3.7."))
        throw FileError("'" + povray.program + "' is POV-Ray " + povray.version +
                        ", but the export is written for 3.7");
    return povray;
}

std::vector<std::string> povray_arguments(int width, int height, int threads) {
    return {"+Iscene.pov",
            "+Oscene.png",
            fmt::format("+W{}", width),
            fmt::format("+H{}", height),
            "+FN16",
            "File_Gamma=1.0",
            "-D",
            "-A",
            fmt::format("+WT{}", threads),
            "-GD",
            "-GR",
            "-GS"};
}

PovPicture run_povray(const PovRay& povray, const PovJob& job, const PovOptions& options) {
    PovPicture picture;
    picture.command =
        joined(povray.program, povray_arguments(job.width, job.height, options.threads));
    const std::string key = options.cache.empty() ? "" : cache_key(povray, job);
    if (!key.empty()) {
        if (const std::optional<CacheEntry> entry = read_cache(options.cache, key)) {
            picture.image = to_image(entry->png, job);
            picture.seconds = entry->seconds;
            picture.from_cache = true;
            return picture;
        }
    }
    const std::string png = render(povray, job, options, picture);
    picture.image = to_image(png, job);
    if (!key.empty()) write_cache(options.cache, key, {picture.seconds, png});
    return picture;
}

std::vector<PovOutcome> run_povray_jobs(const PovRay& povray, const std::vector<PovJob>& jobs,
                                        const PovOptions& options, int parallel,
                                        const std::function<void(std::size_t)>& on_done) {
    std::vector<PovOutcome> outcomes(jobs.size());
    std::mutex done;
    const int threads =
        parallel > 0 ? parallel
                     : static_cast<int>(std::max(2u, 2 * std::thread::hardware_concurrency()));
    for_each_task(static_cast<int>(jobs.size()), threads, {}, [&](const NextTask& next) {
        for (int task = 0; next(task);) {
            const auto i = static_cast<std::size_t>(task);
            try {
                outcomes[i].picture = run_povray(povray, jobs[i], options);
            } catch (const std::exception& error) {
                outcomes[i].failure = error.what();
            }
            const std::lock_guard lock(done);
            if (on_done) on_done(i);
        }
    });
    return outcomes;
}

}  // namespace lancer::reference
