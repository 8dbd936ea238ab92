#include "reference/povray/cache.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/sha256.h"
#include "model/diagnostic.h"
#include "model/io/file.h"

namespace lancer::reference {

namespace fs = std::filesystem;

namespace {

// An entry is one line "lancer-povray-cache 1 <digest of the PNG> <seconds>" and the PNG.
constexpr std::string_view magic = "lancer-povray-cache 1 ";
constexpr std::size_t digest_size = 64;

fs::path entry_path(const std::string& folder, const std::string& key) {
    return fs::path(folder) / "povray" / key;
}

std::string environment(const char* name) {
    const char* value = std::getenv(name);
    return value ? value : "";
}

}  // namespace

std::string cache_folder() {
    if (std::string own = environment("LANCER_CACHE"); !own.empty()) return own;
    if (const std::string base = environment("XDG_CACHE_HOME"); !base.empty())
        return (fs::path(base) / "lancer").string();
    if (const std::string home = environment("HOME"); !home.empty())
        return (fs::path(home) / ".cache" / "lancer").string();
    return "";
}

std::string cache_key(const PovRay& povray, const PovJob& job) {
    std::string all = framed(magic) + framed(povray.version) + framed(job.text);
    for (const std::string& word : povray_arguments(job.width, job.height, 1)) all += framed(word);
    for (const Asset& asset : job.assets) all += framed(asset.name) + framed(asset.bytes);
    return sha256(all);
}

std::optional<CacheEntry> read_cache(const std::string& folder, const std::string& key) {
    std::ifstream file(entry_path(folder, key), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    const std::size_t line_end = bytes.find('\n');
    const std::size_t number_at = magic.size() + digest_size + 1;
    if (!bytes.starts_with(magic) || line_end == std::string::npos || line_end <= number_at)
        return std::nullopt;
    CacheEntry entry;
    entry.png = bytes.substr(line_end + 1);
    const char* number = bytes.data() + number_at;
    const char* end = bytes.data() + line_end;
    const auto read = std::from_chars(number, end, entry.seconds);
    if (read.ec != std::errc{} || read.ptr != end) return std::nullopt;
    if (bytes.compare(magic.size(), digest_size, sha256(entry.png)) != 0) return std::nullopt;
    return entry;
}

bool write_cache(const std::string& folder, const std::string& key, const CacheEntry& entry) {
    const fs::path path = entry_path(folder, key);
    std::error_code ignored;
    fs::create_directories(path.parent_path(), ignored);
    try {
        io::write_file(
            path.string(),
            fmt::format("{}{} {}\n", magic, sha256(entry.png), entry.seconds) + entry.png);
    } catch (const FileError&) {
        return false;
    }
    return true;
}

}  // namespace lancer::reference
