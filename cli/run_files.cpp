#include "cli/run_files.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <filesystem>

#include "cli/session.h"
#include "model/diagnostic.h"
#include "model/io/file.h"
#include "model/io/file_identity.h"
#include "model/io/temporary_file.h"

namespace lancer::cli {
namespace {

namespace fs = std::filesystem;

/// Whether this is /dev/null, which may receive any number of outputs.
bool is_null_device(const std::string& path) {
    struct stat status {};
    const int failed = path == "-" ? fstat(STDOUT_FILENO, &status) : stat(path.c_str(), &status);
    return failed == 0 && S_ISCHR(status.st_mode) && status.st_rdev == makedev(1, 3);
}

std::string shown(const std::string& path, const char* stream) {
    return path == "-" ? stream : "'" + path + "'";
}

std::string folder_of(const std::string& path) {
    const fs::path folder = fs::path(path).parent_path();
    return folder.empty() ? "." : folder.string();
}

[[noreturn]] void refuse(const std::string& output, const std::string& input) {
    throw UsageError(fmt::format("{} would overwrite {}, which is an input",
                                 shown(output, "standard output"), shown(input, "standard input")));
}

}  // namespace

RunFiles::RunFiles() {
    const io::FileIdentity identity = io::identity_of(STDOUT_FILENO);
    standard_output_ = identity.key;
    if (identity.is_ordinary && !identity.key.empty()) outputs_[identity.key] = {"-", ""};
}

void RunFiles::add_input(const std::string& path) {
    const io::FileIdentity identity =
        path == "-" ? io::identity_of(STDIN_FILENO) : io::identity_of(path);
    if (!identity.is_ordinary || identity.key.empty()) return;
    inputs_.emplace(identity.key, path);
    const auto output = outputs_.find(identity.key);
    if (output != outputs_.end()) refuse(output->second.name, path);
}

void RunFiles::check_folder(const std::string& folder, const std::string& path) {
    if (writable_folders_.contains(folder)) return;
    std::error_code ignored;
    if (!fs::is_directory(folder, ignored))
        throw FileError(fmt::format("cannot write '{}': there is no folder '{}'", path, folder));
    const io::TemporaryFile trial(folder, "", path);
    writable_folders_.insert(folder);
}

/// Fails now and not after an hour of tracing.
void RunFiles::check_writable(const std::string& path) {
    std::error_code ignored;
    if (path == "-" || (io::is_stream(path) && fs::exists(path, ignored))) return;
    if (fs::is_directory(path, ignored))
        throw FileError(fmt::format("cannot write '{}': it is a folder", path));
    check_folder(folder_of(io::follow_links(path)), path);
}

void RunFiles::enter_output(const std::string& path, const std::string& option) {
    const io::FileIdentity identity =
        path == "-" ? io::identity_of(STDOUT_FILENO) : io::identity_of(path);
    if (is_null_device(path)) return;
    const auto input = inputs_.find(identity.key);
    if (input != inputs_.end()) refuse(path, input->second);
    Output& there = outputs_[identity.key];
    if (!there.option.empty() && there.option != option) {
        throw UsageError(fmt::format("{} would be written twice, for {} and for {}",
                                     shown(path, "standard output"), there.option, option));
    }
    there = {path, option};
    takes_standard_output_ = takes_standard_output_ || identity.key == standard_output_;
}

void RunFiles::add_output(const std::string& path, const std::string& option) {
    if (path.empty()) return;
    enter_output(path, option);
    check_writable(path);
}

void RunFiles::add_output_in_new_folder(const std::string& path, const std::string& option) {
    enter_output(path, option);
    std::error_code ignored;
    fs::path folder = folder_of(path);
    if (fs::exists(folder, ignored)) return check_writable(path);
    while (!fs::exists(folder, ignored)) folder = folder_of(folder);  // "." and "/" always exist
    check_folder(folder, path);
}

}  // namespace lancer::cli
