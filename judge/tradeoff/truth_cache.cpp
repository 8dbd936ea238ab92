#include "judge/tradeoff/truth_cache.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/sha256.h"
#include "model/diagnostic.h"
#include "model/io/file.h"

namespace lancer::judge {
namespace {

namespace fs = std::filesystem;

// An entry is one line "lancer-truth 1 <digest of the rest>" and the sums.
constexpr std::string_view magic = "lancer-truth 1 ";
constexpr std::size_t digest_size = 64;

fs::path entry_path(const TruthCache& cache, const std::string& key) {
    return fs::path(cache.folder) / "truth" / key;
}

}  // namespace

std::string truth_key(const std::string& content, const View& view, const TraceLimits& limits,
                      std::uint64_t seed) {
    const Crop part = view.crop.value_or(Crop{0, 0, view.width, view.height});
    return sha256(fmt::format("{}{}:{} camera {} size {}x{} crop {},{},{},{} limits {} {} seed {}",
                              magic, content.size(), content, view.camera, view.width, view.height,
                              part.x, part.y, part.width, part.height, limits.max_depth,
                              limits.min_contribution, seed));
}

bool read_truth(const TruthCache& cache, const std::string& key, TruePicture& picture) {
    if (cache.folder.empty()) return false;
    std::ifstream file(entry_path(cache, key), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    const std::size_t begin = magic.size() + digest_size + 1;
    if (!bytes.starts_with(magic) || bytes.size() <= begin || bytes[begin - 1] != '\n')
        return false;
    const std::string_view sums = std::string_view(bytes).substr(begin);
    if (bytes.compare(magic.size(), digest_size, sha256(sums)) != 0) return false;
    return picture.restore(sums);
}

void write_truth(const TruthCache& cache, const std::string& key, const TruePicture& picture) {
    if (cache.folder.empty()) return;
    const fs::path path = entry_path(cache, key);
    std::error_code ignored;
    fs::create_directories(path.parent_path(), ignored);
    const std::string sums = picture.bytes();
    try {
        io::write_file(path.string(), fmt::format("{}{}\n", magic, sha256(sums)) + sums);
    } catch (const FileError&) {  // a failure only costs time
    }
}

}  // namespace lancer::judge
