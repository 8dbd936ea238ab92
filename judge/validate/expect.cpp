#include "judge/validate/expect.h"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <set>

#include "model/diagnostic.h"
#include "model/io/file.h"

namespace lancer::judge {

namespace {

constexpr std::string_view blanks = " \t\r";

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// A key whose value is a number in least..most.
struct NumberKey {
    std::string_view name;
    double Thresholds::*number;
    double least;
    double most;
};
constexpr NumberKey number_keys[] = {
    {"interior", &Thresholds::interior, 1e-6, 1},
    {"tight", &Thresholds::tight, 1e-6, 1},
    {"tight_share", &Thresholds::tight_share, 0, 1},
    {"explained_share", &Thresholds::explained_share, 0, 1},
    {"displaced_share", &Thresholds::displaced_share, 0, 1},
    {"outlier_share", &Thresholds::outlier_share, 0, 1},
    {"shift", &Thresholds::shift, 0, 1},
};
struct CountKey {
    std::string_view name;
    std::size_t Thresholds::*count;
};
constexpr CountKey count_keys[] = {
    {"unexplained", &Thresholds::unexplained},
};

std::string known_keys() {
    std::string list;
    for (const NumberKey& key : number_keys) list += fmt::format("{}, ", key.name);
    for (const CountKey& key : count_keys) list += fmt::format("{}, ", key.name);
    return list + "refused";
}

/// Parses `text` as a number of this type; throws a message without a place.
template <class Number>
Number parsed(std::string_view text) {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) {
        throw FileError(fmt::format("'{}' is not a valid number", text));
    }
    return value;
}

void set_value(Expectations& result, std::string_view key, std::string_view value,
               std::string_view reason) {
    for (const NumberKey& known : number_keys) {
        if (known.name != key) continue;
        const auto number = parsed<double>(value);
        if (!(number >= known.least && number <= known.most)) {
            throw FileError(
                fmt::format("{} must be between {:g} and {:g}", key, known.least, known.most));
        }
        result.thresholds.*known.number = number;
        return;
    }
    for (const CountKey& known : count_keys) {
        if (known.name != key) continue;
        result.thresholds.*known.count = parsed<std::size_t>(value);
        return;
    }
    if (key != "refused") {
        throw FileError(fmt::format("unknown key '{}'; known keys are {}", key, known_keys()));
    }
    if (value != "yes") throw FileError("refused takes only the value yes");
    result.refused = true;
    result.refusal_reason = reason;
}

void read_line(Expectations& result, std::string_view line, std::set<std::string>& seen) {
    const std::size_t hash = line.find('#');
    const std::string_view reason =
        hash == std::string_view::npos ? std::string_view{} : trimmed(line.substr(hash + 1));
    const std::string_view setting = trimmed(line.substr(0, hash));
    if (setting.empty()) return;
    const std::size_t gap = setting.find_first_of(blanks);
    const std::string_view key = setting.substr(0, gap);
    const std::string_view value =
        gap == std::string_view::npos ? std::string_view{} : trimmed(setting.substr(gap));
    if (value.empty()) throw FileError(fmt::format("{} has no value", key));
    if (reason.empty())
        throw FileError(
            fmt::format("{} needs a reason, written as: {} {}  # why", key, key, value));
    if (!seen.emplace(key).second) throw FileError(fmt::format("{} is given twice", key));
    set_value(result, key, value, reason);
    result.reasons.push_back(fmt::format("{} {}: {}", key, value, reason));
}

}  // namespace

Expectations parse_expectations(std::string_view text, const std::string& name) {
    Expectations result;
    std::set<std::string> seen;
    for (std::size_t number = 1; !text.empty(); ++number) {
        const std::size_t end = text.find('\n');
        try {
            read_line(result, text.substr(0, end), seen);
        } catch (const FileError& error) {
            throw FileError(fmt::format("{}:{}: {}", name, number, error.what()));
        }
        text = end == std::string_view::npos ? std::string_view{} : text.substr(end + 1);
    }
    return result;
}

std::string expectations_beside(const std::string& scene_path) {
    return std::filesystem::path(scene_path).replace_extension(".expect").string();
}

Expectations read_expectations(const std::string& scene_path) {
    const std::string path = expectations_beside(scene_path);
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored)) return {};
    return parse_expectations(io::read_file(path, std::size_t{1} << 20), path);
}

}  // namespace lancer::judge
