#include "cli/output_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "cli/session.h"
#include "model/diagnostic.h"
#include "model/io/file.h"

namespace lancer::cli {

std::string default_output(const std::string& scene, bool is_preview) {
    const std::filesystem::path name =
        scene == "-" ? "stdin" : std::filesystem::path(scene).filename().replace_extension();
    return name.string() + (is_preview ? "-preview.png" : ".png");
}

std::string default_part(const std::string& scene, int number, int count) {
    const std::string whole = default_output(scene);
    return fmt::format("{}-part-{}-of-{}.exr", whole.substr(0, whole.size() - 4), number, count);
}

std::string ending_of(const std::string& path) {
    std::string ending = std::filesystem::path(path).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

void check_picture_name(const std::string& output, const io::ImageWriteOptions& options, bool aov) {
    std::error_code ignored;
    if (std::filesystem::is_directory(output, ignored))
        throw FileError(fmt::format("cannot write '{}': it is a folder", output));
    if (!io::is_writable_image_name(output)) {
        throw UsageError(fmt::format(
            "'{}': the name of a picture must end in .png .exr .hdr .tif .tiff .jpg .jpeg or .ppm",
            output));
    }
    const std::string ending = ending_of(output);
    if (aov && ending != ".exr") throw UsageError("--aov needs an .exr file: -o OUT.exr");
    const bool is_deep =
        ending == ".png" || ending == ".tif" || ending == ".tiff" || ending == ".ppm";
    if (options.bits == 16 && !is_deep)
        throw UsageError(fmt::format("--bits 16 is for .png, .tif and .ppm, not for '{}'", output));
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
                "'{}' is not a pattern for frames: expected one %d, as in out-%04d.png", pattern));
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
    // As in printf: zeros follow the sign, blanks precede it.
    digits = fill_ == '0' ? sign + padding + digits : padding + sign + digits;
    return before_ + digits + after_;
}

}  // namespace lancer::cli
