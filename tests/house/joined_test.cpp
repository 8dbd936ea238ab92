// cmake/joined.cmake compiles several sources of a library as one, so a private name must be unique
// among them. The presets for developers do not join, so this test checks it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "tests/house/source_text.h"

namespace {

namespace fs = std::filesystem;

/// The words of `lancer_join(... APART words)`; nothing where the folder joins nothing.
std::vector<std::string> words_apart(const std::string& folder) {
    const std::string text = read_text(root / folder / "CMakeLists.txt");
    std::smatch join;
    if (!std::regex_search(text, join, std::regex(R"re(lancer_join\(\w+ APART ([^)]*)\))re")))
        return {};
    std::istringstream words(join[1].str());
    return {std::istream_iterator<std::string>(words), {}};
}

/// The declaration on a line without indentation: a type, a variable or an alias by its name; a
/// function by the whole line, since others may have the same name with other parameters.
std::string declared_in(const std::string& line) {
    static const std::regex type(R"re(^(struct|class|enum class|enum) (\w+).*\{)re");
    static const std::regex alias(R"re(^using \w+ = .*;)re");
    static const std::regex variable(
        R"re(^(const|constexpr|static|std::\w+) [^(]*?(\w+)(\[.*\])? ?(=|\{|;))re");
    static const std::regex function(R"re(^[\w:].* [*&]?(\w+\(.*))re");
    std::smatch match;
    if (std::regex_search(line, match, type)) return match[2].str();
    if (std::regex_search(line, alias)) return "";  // repeating an alias is allowed
    if (std::regex_search(line, match, variable)) return match[2].str();
    if (std::regex_search(line, match, function)) return match[1].str();
    return "";
}

std::vector<std::string> private_names(const fs::path& path) {
    std::vector<std::string> names;
    std::vector<bool> unnamed;  // of the namespaces around
    std::istringstream in(read_text(path));
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with("namespace ") && line.ends_with("{")) {
            unnamed.push_back(line == "namespace {");
        } else if (line.starts_with("}  // namespace")) {
            if (!unnamed.empty()) unnamed.pop_back();
        } else if (std::find(unnamed.begin(), unnamed.end(), true) != unnamed.end()) {
            if (std::string name = declared_in(line); !name.empty()) names.push_back(name);
        }
    }
    return names;
}

TEST(Joined, SourcesHaveNoPrivateNameTwice) {
    std::vector<std::string> twice;
    std::size_t seen = 0;
    for (const std::string folder : {"cli", "judge", "model/io", "parser", "reference"}) {
        const std::vector<std::string> apart = words_apart(folder);
        ASSERT_FALSE(apart.empty()) << folder;
        std::map<std::string, std::string> owner;
        for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
            const std::string path = fs::relative(entry.path(), root).generic_string();
            const bool other_library =
                path.starts_with("cli/pages/") || path.starts_with("model/io/module/");
            if (!path.ends_with(".cpp") || other_library) continue;
            if (std::any_of(apart.begin(), apart.end(), [&](const std::string& word) {
                    return path.find(word, folder.size()) != std::string::npos;
                }))
                continue;
            for (const std::string& name : private_names(entry.path())) {
                ++seen;
                const auto [first, is_new] = owner.try_emplace(name, path);
                if (!is_new && first->second != path)
                    twice.push_back(name + " in " + first->second + " and " + path);
            }
        }
    }
    EXPECT_GT(seen, 300u);
    EXPECT_THAT(twice, testing::IsEmpty())
        << "rename one, or name its source in lancer_join(... APART ...)";
}

}  // namespace
