// Every word of the language occurs in a scene, so that each is rendered by some test.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "parser/functions.h"
#include "parser/vocabulary.h"

namespace lancer {
namespace {

namespace fs = std::filesystem;

/// The scripts below scenes/, except those with intended errors, without comments and strings.
std::vector<std::string> scripts() {
    std::vector<std::string> texts;
    const std::regex comment(R"re(//[^\n]*|/\*[^*]*\*+([^/*][^*]*\*+)*/|"[^"\n]*")re");
    for (const auto& entry :
         fs::recursive_directory_iterator(fs::path(LANCER_SOURCE_DIR) / "scenes")) {
        const std::string path = entry.path().generic_string();
        if (!path.ends_with(".lancer") || path.find("/bad/") != std::string::npos) continue;
        std::ifstream in(path);
        const std::string text{std::istreambuf_iterator<char>(in), {}};
        texts.push_back(std::regex_replace(text, comment, " "));
    }
    return texts;
}

/// The words of each script.
std::vector<std::set<std::string>> words_of_scripts() {
    static const std::regex word("[A-Za-z_][A-Za-z0-9_]*");
    std::vector<std::set<std::string>> all;
    for (const std::string& text : scripts()) {
        std::set<std::string> words;
        for (auto match = std::sregex_iterator(text.begin(), text.end(), word);
             match != std::sregex_iterator(); ++match)
            words.insert(match->str());
        all.push_back(std::move(words));
    }
    return all;
}

class Keywords : public testing::Test {
  protected:
    /// Whether one script has all these words.
    bool stand_together(const std::vector<std::string>& wanted) const {
        for (const auto& words : words_) {
            bool all = true;
            for (const std::string& word : wanted) all = all && words.contains(word);
            if (all) return true;
        }
        return false;
    }
    const std::vector<std::set<std::string>> words_ = words_of_scripts();
};

TEST_F(Keywords, EveryPropertyOfEveryBlockHasAScene) {
    Symbols symbols;
    const Vocabulary vocabulary(symbols);
    std::vector<std::string> missing;
    std::size_t seen = 0;
    for (const BlockWord& block : vocabulary.blocks()) {
        std::vector<std::string> head;
        for (const Symbol part : {block.keyword, block.kind}) {
            if (part != no_symbol) head.emplace_back(symbols.text(part));
        }
        for (std::size_t i = 0; i < block.own_fields; ++i) {
            const Field& field = block.properties.field(static_cast<std::uint8_t>(i));
            ++seen;
            std::vector<std::string> wanted = head;
            wanted.emplace_back(field.name);
            if (!stand_together(wanted))
                missing.push_back(head.back() + " " + std::string(field.name));
            for (const std::string_view word : field.words) {
                wanted.back() = word;
                if (!stand_together(wanted))
                    missing.push_back(head.back() + " " + std::string(field.name) + " " +
                                      std::string(word));
            }
        }
        for (std::size_t i = block.own_fields; i < block.properties.fields().size(); ++i) {
            const std::string name(block.properties.fields()[i]->name);
            if (!stand_together({name})) missing.push_back(name);
        }
    }
    EXPECT_GT(seen, 60u);
    EXPECT_THAT(missing, testing::IsEmpty());
}

TEST_F(Keywords, EveryStatementFunctionAndConstantHasAScene) {
    std::vector<std::string> words{"include", "let",  "param",  "def",   "func", "for",  "in",
                                   "if",      "else", "assert", "print", "true", "false"};
    for (const Function& function : all_functions()) words.emplace_back(function.name);
    for (const Constant& constant : all_constants()) words.emplace_back(constant.name);
    std::vector<std::string> missing;
    for (const std::string& word : words) {
        if (!stand_together({word})) missing.push_back(word);
    }
    EXPECT_THAT(missing, testing::IsEmpty());
}

}  // namespace
}  // namespace lancer
