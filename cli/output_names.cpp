#include "cli/output_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "cli/session.h"
#include "model/diagnostic.h"
#include "model/io/file.h"
#include "model/io/temporary_file.h"

namespace lancer::cli {

std::string default_output(const std::string& scene) {
    if (scene == "-") return "stdin.png";
    return std::filesystem::path(scene).filename().replace_extension(".png").string();
}

std::string ending_of(const std::string& path) {
    std::string ending = std::filesystem::path(path).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

bool is_same_file(const std::string& a, const std::string& b) {
    if (a.empty() || b.empty() || a == "-" || b == "-" || io::is_stream(a)) return false;
    std::error_code ignored;
    return std::filesystem::weakly_canonical(a, ignored) ==
           std::filesystem::weakly_canonical(b, ignored);
}

void check_spared(const std::string& output, const std::vector<std::string>& others) {
    for (const std::string& other : others)
        if (is_same_file(output, other))
            throw UsageError(fmt::format("'{}' would be written over '{}'", output, other));
}

void check_writable(const std::string& path) {
    std::error_code ignored;
    if (io::is_stream(path) && std::filesystem::exists(path, ignored)) return;
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    const std::string where = folder.empty() ? "." : folder.string();
    if (!std::filesystem::is_directory(where, ignored))
        throw FileError(fmt::format("cannot write '{}': there is no folder '{}'", path, where));
    const io::TemporaryFile trial(where, ending_of(path), path);
    if (std::filesystem::is_directory(path, ignored))
        throw FileError(fmt::format("cannot write '{}': it is a folder", path));
}

FrameNames::FrameNames(const std::string& pattern) {
    constexpr std::size_t widest = 20;
    bool number_found = false;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        std::string& part = number_found ? after_ : before_;
        if (pattern[i] != '%') {
            part += pattern[i];
            continue;
        }
        if (pattern.substr(i + 1, 1) == "%") {
            part += '%';
            ++i;
            continue;
        }
        std::size_t at = i + 1;
        fill_ = pattern.substr(at, 1) == "0" ? '0' : ' ';
        std::size_t width = 0;
        while (at < pattern.size() && std::isdigit(static_cast<unsigned char>(pattern[at])) != 0 &&
               width <= widest)
            width = width * 10 + static_cast<std::size_t>(pattern[at++] - '0');
        if (number_found || width > widest || pattern.substr(at, 1) != "d") {
            throw UsageError(fmt::format(
                "'{}' is no pattern for frames: expected one %d, as in out-%04d.png", pattern));
        }
        width_ = width;
        number_found = true;
        i = at;
    }
    if (number_found) return;
    const std::filesystem::path path(before_);
    after_ = path.extension().string();
    before_ = before_.substr(0, before_.size() - after_.size()) + "-";
    fill_ = '0';
    width_ = 4;
}

std::string FrameNames::name(std::int64_t frame) const {
    std::string digits = std::to_string(frame < 0 ? -frame : frame);
    const std::string sign = frame < 0 ? "-" : "";
    const std::size_t length = digits.size() + sign.size();
    const std::string padding(width_ > length ? width_ - length : 0, fill_);
    // As printf: zeros stand after the sign, blanks before it.
    digits = fill_ == '0' ? sign + padding + digits : padding + sign + digits;
    return before_ + digits + after_;
}

}  // namespace lancer::cli
