// Statements of the documentation about the sources are true.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include "tests/house/source_text.h"

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> pages() {
    std::vector<fs::path> found{root / "README.md"};
    for (const auto& entry : fs::recursive_directory_iterator(root / "docs")) {
        if (entry.path().extension() == ".md") found.push_back(entry.path());
    }
    std::sort(found.begin(), found.end());
    return found;
}

std::vector<std::string> all_matches(const std::string& text, const std::string& pattern) {
    const std::regex regex(pattern);
    std::vector<std::string> found;
    for (auto match = std::sregex_iterator(text.begin(), text.end(), regex);
         match != std::sregex_iterator(); ++match)
        found.push_back((*match)[1].str());
    return found;
}

TEST(Docs, LinksLeadSomewhere) {
    std::vector<std::string> broken;
    std::size_t seen = 0;
    for (const fs::path& page : pages()) {
        for (std::string link : all_matches(read_text(page), R"re(\]\(([^)\s]+)\))re")) {
            if (link.starts_with("http")) continue;
            ++seen;
            link = link.substr(0, link.find('#'));
            if (!link.empty() && !fs::exists(page.parent_path() / link))
                broken.push_back(fs::relative(page, root).string() + ": " + link);
        }
    }
    EXPECT_GT(seen, 2u);
    EXPECT_THAT(broken, testing::IsEmpty());
}

const std::string folders =
    "(?:base|model|parser|tracer|reference|judge|cli|tests|cmake|scenes|docs)";
const std::string source_file = folders + R"re(/[\w/]+\.(?:h|cpp|sh|cmake))re";

TEST(Docs, FilesAndFoldersThatPagesNameExist) {
    const std::string named = "`(" + folders + R"re(/[\w/.-]*)`)re";
    std::vector<std::string> missing;
    std::size_t seen = 0;
    for (const fs::path& page : pages()) {
        for (const std::string& name : all_matches(read_text(page), named)) {
            ++seen;
            if (!fs::exists(root / name))
                missing.push_back(fs::relative(page, root).string() + ": " + name);
        }
    }
    EXPECT_GT(seen, 100u);
    EXPECT_THAT(missing, testing::IsEmpty());
}

/// `name` in `file`, `name` (`file`) and `file`: `name`.
TEST(Docs, NamesBesideAFileStandInIt) {
    const std::vector<std::pair<std::regex, bool>> forms{
        {std::regex("`(" + source_file + R"re()`[*]{0,2}:\s`(\w+)`)re"), true},
        {std::regex(R"re(`(\w+)`\s(?:\(|in\s)`()re" + source_file + ")`"), false}};
    std::vector<std::string> missing;
    std::size_t seen = 0;
    for (const fs::path& page : pages()) {
        const std::string text = read_text(page);
        for (const auto& [form, file_first] : forms) {
            for (auto match = std::sregex_iterator(text.begin(), text.end(), form);
                 match != std::sregex_iterator(); ++match) {
                const std::string file = (*match)[file_first ? 1 : 2].str();
                const std::string name = (*match)[file_first ? 2 : 1].str();
                ++seen;
                if (!std::regex_search(read_text(root / file), std::regex("\\b" + name + "\\b")))
                    missing.push_back(fs::relative(page, root).string() + ": " + name + " in " +
                                      file);
            }
        }
    }
    EXPECT_GT(seen, 30u);
    EXPECT_THAT(missing, testing::IsEmpty());
}

TEST(Docs, ProgramsOfTestsThatPagesNameExist) {
    std::vector<std::string> programs;
    for (const auto& entry : fs::recursive_directory_iterator(root / "tests"))
        if (entry.path().extension() == ".cpp") programs.push_back(entry.path().stem().string());
    std::vector<std::string> missing;
    std::size_t seen = 0;
    for (const fs::path& page : pages()) {
        for (const std::string& name :
             all_matches(read_text(page), R"re(`(bench_\w+|\w+_test|\w+_fuzz)[ `])re")) {
            ++seen;
            if (std::find(programs.begin(), programs.end(), name) == programs.end())
                missing.push_back(fs::relative(page, root).string() + ": " + name);
        }
    }
    EXPECT_GT(seen, 1u);
    EXPECT_THAT(missing, testing::IsEmpty());
}

/// A code block that begins with `// scenes/NAME` quotes that scene, whole.
TEST(Docs, QuotedScenesAreTheFiles) {
    std::vector<std::string> wrong;
    std::size_t seen = 0;
    for (const fs::path& page : pages()) {
        const std::string text = read_text(page);
        for (std::size_t at = 0; (at = text.find("```\n// scenes/", at)) != std::string::npos;) {
            const std::size_t name = at + 7;
            const std::size_t body = text.find('\n', name) + 1;
            const std::size_t end = text.find("```", body);
            ++seen;
            const std::string file = text.substr(name, body - 1 - name);
            if (read_text(root / file) != text.substr(body, end - body)) wrong.push_back(file);
            at = end + 3;
        }
    }
    EXPECT_GT(seen, 0u);
    EXPECT_THAT(wrong, testing::IsEmpty());
}

/// Every `name` in the second column of docs/lineage.md stands in one of the files named beside it.
TEST(Docs, NamesInTheLineageStandInTheirFiles) {
    std::vector<std::string> missing;
    std::size_t rows = 0;
    std::ifstream page(root / "docs" / "lineage.md");
    for (std::string line; std::getline(page, line);) {
        if (!line.starts_with("| ") || line.starts_with("| In the course")) continue;
        ++rows;
        const std::size_t first = line.find(" | ") + 3;
        const std::string here = line.substr(first, line.find(" | ", first) - first);
        std::string files;
        std::vector<std::string> names;
        for (const std::string& token : all_matches(here, "`([^`]+)`")) {
            if (token.find('/') != std::string::npos) {
                files += read_text(root / token);
            } else {
                names.push_back(token);
            }
        }
        for (const std::string& name : names) {
            if (!std::regex_search(files, std::regex("\\b" + name + "\\b")))
                missing.push_back(name);
        }
    }
    EXPECT_GT(rows, 20u);
    EXPECT_THAT(missing, testing::IsEmpty());
}

}  // namespace
