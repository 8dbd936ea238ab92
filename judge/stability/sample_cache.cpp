#include "judge/stability/sample_cache.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "base/sha256.h"
#include "model/diagnostic.h"
#include "model/io/file.h"

namespace lancer::judge {
namespace {

namespace fs = std::filesystem;

// An entry is one line "lancer-stability 1 <digest of the rest>", a line of numbers, and the reason
// if there is no picture.
constexpr std::string_view magic = "lancer-stability 1 ";

fs::path entry_path(const SampleCache& cache, Change change, int exponent) {
    const std::string made_from = fmt::format("{}{}:{} {} {}", magic, cache.content.size(),
                                              cache.content, name_of(change), exponent);
    return fs::path(cache.folder) / "stability" / sha256(made_from);
}

}  // namespace

std::optional<Sample> kept_sample(const SampleCache& cache, Change change, int exponent) {
    if (cache.folder.empty()) return std::nullopt;
    std::ifstream file(entry_path(cache, change, exponent), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    const std::size_t begin = magic.size() + sha256_digits + 1;
    if (!bytes.starts_with(magic) || bytes.size() <= begin) return std::nullopt;
    const std::string rest = bytes.substr(begin);
    if (bytes.compare(magic.size(), sha256_digits, sha256(rest)) != 0) return std::nullopt;
    Sample sample;
    std::istringstream numbers(rest);
    numbers >> sample.exponent >> sample.wrong >> sample.different >> sample.right >> sample.most;
    if (!numbers || sample.exponent != exponent) return std::nullopt;
    sample.failure = rest.substr(std::min(rest.find('\n'), rest.size() - 1) + 1);
    return sample;
}

void keep_sample(const SampleCache& cache, Change change, const Sample& sample) {
    if (cache.folder.empty()) return;
    const fs::path path = entry_path(cache, change, sample.exponent);
    std::error_code ignored;
    fs::create_directories(path.parent_path(), ignored);
    const std::string rest =
        fmt::format("{} {} {} {:d} {}\n{}", sample.exponent, sample.wrong, sample.different,
                    sample.right, sample.most, sample.failure);
    try {
        io::write_file(path.string(), fmt::format("{}{}\n", magic, sha256(rest)) + rest);
    } catch (const FileError&) {  // a failure only costs time
    }
}

}  // namespace lancer::judge
