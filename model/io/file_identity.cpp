#include "model/io/file_identity.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <filesystem>

#include "model/diagnostic.h"
#include "model/io/file.h"

namespace lancer::io {
namespace {

FileIdentity identity_in(const struct stat& status) {
    return {fmt::format("{}:{}", status.st_dev, status.st_ino), S_ISREG(status.st_mode)};
}

/// The end of a chain of links, or `path` itself for a cycle, so that opening it fails.
std::string target_of(const std::string& path) {
    try {
        return follow_links(path);
    } catch (const FileError&) {
        return path;
    }
}

}  // namespace

FileIdentity identity_of(const std::string& path) {
    struct stat status {};
    if (stat(path.c_str(), &status) == 0) return identity_in(status);
    const std::filesystem::path target = target_of(path);
    const std::string folder = target.has_parent_path() ? target.parent_path().string() : ".";
    if (stat(folder.c_str(), &status) == 0)
        return {identity_in(status).key + "/" + target.filename().string(), true};
    std::error_code ignored;
    return {std::filesystem::weakly_canonical(target, ignored).string(), true};
}

FileIdentity identity_of(int descriptor) {
    struct stat status {};
    if (fstat(descriptor, &status) != 0) return {};
    return identity_in(status);
}

}  // namespace lancer::io
