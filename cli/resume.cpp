#include "cli/resume.h"

#include <fmt/format.h>

#include <filesystem>

#include "model/diagnostic.h"
#include "model/io/file.h"
#include "model/io/part_file.h"

namespace lancer::cli {
namespace {

bool is_there(const std::string& path) {
    std::error_code ignored;
    return std::filesystem::exists(path, ignored);
}

Found judged(const io::Origin& there, const io::Origin& wanted) {
    const std::string other = io::difference(there, wanted);
    if (other.empty()) return {true, ""};
    return {false, "it is of " + other};
}

}  // namespace

Found found_picture(const std::string& path, const io::Origin& wanted) {
    if (!is_there(path)) return {};
    try {
        const std::optional<io::Origin> there = io::origin_of_picture(io::read_file(path));
        if (!there) return {false, "it is damaged, or was not written by a run with --resume"};
        return judged(*there, wanted);
    } catch (const FileError& error) {
        return {false, error.what()};
    }
}

Found found_part(const std::string& path, const io::PartHead& wanted) {
    if (!is_there(path)) return {};
    try {
        const io::PartHead there = io::checked_part(path);
        if (there.number != wanted.number || there.count != wanted.count) {
            return {false, fmt::format("it is part {} of {}", there.number, there.count)};
        }
        return judged(there.origin, wanted.origin);
    } catch (const FileError& error) {
        return {false, error.what()};
    }
}

}  // namespace lancer::cli
