#include "cli/sweep_share.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <filesystem>

#include "cli/session.h"
#include "model/diagnostic.h"
#include "model/io/temporary_file.h"

namespace lancer::cli {
namespace {

/// Fails now and not after an hour. Other commands only lose time when the cache cannot be written.
void check_writable(const std::string& cache) {
    std::error_code error;
    std::filesystem::create_directories(cache, error);
    if (error)
        throw FileError(fmt::format("cannot write the cache '{}': {}", cache, error.message()));
    const io::TemporaryFile trial(cache, "", cache);
}

}  // namespace

void add_share_option(CLI::App& app, std::optional<PartOf>& part, const std::string& what) {
    app.add_option_function<std::string>(
           "--part", [&part](const std::string& text) { part = parse_part(text); },
           "Every N-th " + what +
               " from the K-th on; the cache keeps the results for a run over all of them")
        ->type_name("K/N");
}

void check_share(const std::optional<PartOf>& part, const std::string& report,
                 const std::string& cache) {
    if (!part) return;
    if (!report.empty())
        throw UsageError(report + " is about all scenes: write it by a last run without --part");
    if (cache.empty()) throw UsageError("--part keeps its results in the cache: remove --no-cache");
    check_writable(cache);
}

std::vector<std::string> share_of(const std::vector<std::string>& scenes,
                                  const std::optional<PartOf>& part, const std::string& report,
                                  const std::string& cache) {
    check_share(part, report, cache);
    if (!part) return scenes;
    std::vector<std::string> share;
    for (std::size_t i = 0; i < scenes.size(); ++i)
        if (part->has(static_cast<std::int64_t>(i))) share.push_back(scenes[i]);
    return share;
}

}  // namespace lancer::cli
