// Every scene in scenes/bad/ gets exactly the expected messages beside it, and every message of the
// parser has a scene. If LANCER_WRITE_EXPECTED is set, the messages are written, to be checked by a
// person.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "model/io/file.h"
#include "parser/messages.h"
#include "parser/parse.h"

namespace lancer {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> bad_scenes() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(fs::path(LANCER_SOURCE_DIR) / "scenes/bad"))
        if (entry.path().extension() == ".lancer") names.push_back(entry.path().stem());
    std::sort(names.begin(), names.end());
    return names;
}

/// The output of `lancer check`, run from the project's folder.
std::string check(const std::string& path) {
    fs::current_path(LANCER_SOURCE_DIR);
    SourceMap sources;
    std::vector<Diagnostic> found;
    const Script script = parse_script(path, io::read_file(path), {}, sources, found);
    evaluate(script, {}, {}, sources, found);
    std::string shown;
    const auto count = [&](Severity severity) {
        return std::count_if(found.begin(), found.end(),
                             [&](const Diagnostic& d) { return d.severity == severity; });
    };
    for (const Diagnostic& diagnostic : found) shown += format(diagnostic, sources);
    const auto errors = count(Severity::error);
    const auto warnings = count(Severity::warning);
    if (errors > 1) shown += std::to_string(errors) + " errors\n";
    if (errors == 0 && warnings > 1) shown += std::to_string(warnings) + " warnings\n";
    return shown;
}

class BadScene : public testing::TestWithParam<std::string> {};

TEST_P(BadScene, GetsTheMessagesThatStandBesideIt) {
    const std::string base = "scenes/bad/" + GetParam();
    const std::string shown = check(base + ".lancer");
    if (std::getenv("LANCER_WRITE_EXPECTED") != nullptr)
        std::ofstream(base + ".expected", std::ios::binary) << shown;
    EXPECT_EQ(shown, io::read_file(base + ".expected"));
    EXPECT_NE(shown, "");
}

INSTANTIATE_TEST_SUITE_P(All, BadScene, testing::ValuesIn(bad_scenes()),
                         [](const auto& scene) { return scene.param; });

/// True when some line has the pieces of a format string around its `{}` in order.
bool is_shown(std::string_view text, const std::string& all) {
    std::vector<std::string> pieces(1);
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text.substr(i, 2) == "{}") {
            pieces.emplace_back();
            ++i;
        } else {
            if (text.substr(i, 2) == "{{" || text.substr(i, 2) == "}}") ++i;
            pieces.back() += text[i];
        }
    }
    for (std::size_t from = 0; (from = all.find(": " + pieces[0], from)) != std::string::npos;
         ++from) {
        std::size_t at = from + 2;
        const std::size_t end = all.find('\n', from);
        bool whole = true;
        for (const std::string& piece : pieces) {
            at = all.find(piece, at);
            whole = whole && at != std::string::npos && at + piece.size() <= end;
            if (!whole) break;
            at += piece.size();
        }
        if (whole) return true;
    }
    return false;
}

TEST(BadScenes, ThereIsOneForEveryMessage) {
    // Messages about the command line, or for a text too long for a repository: limits_test.cpp and
    // definitions_test.cpp test these. One needs more memory than a test should use:
    // computed_lists_test.cpp. And one only occurs together with another message.
    const std::vector<Message> elsewhere{
        Message::source_limit,       Message::after_definition,    Message::held_limit,
        Message::unknown_definition, Message::definition_is_block, Message::file_unreadable,
        Message::mesh_file};
    std::string all;
    for (const std::string& name : bad_scenes())
        all += io::read_file(std::string(LANCER_SOURCE_DIR) + "/scenes/bad/" + name + ".expected");
    for (std::size_t i = 0; i < std::size(message_texts); ++i) {
        if (std::find(elsewhere.begin(), elsewhere.end(), static_cast<Message>(i)) !=
            elsewhere.end())
            continue;
        EXPECT_TRUE(is_shown(message_texts[i], all)) << message_texts[i];
    }
}

TEST(BadScenes, AreFortyOrMore) {
    EXPECT_GE(bad_scenes().size(), 40u);
}

}  // namespace
}  // namespace lancer
