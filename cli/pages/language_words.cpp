#include "cli/pages/language_words.h"

#include "parser/field.h"
#include "parser/functions.h"

namespace lancer::cli {

LanguageWords language_words() {
    LanguageWords words;
    words.statements = {"include", "let", "param", "def",    "func", "for",
                        "in",      "if",  "else",  "assert", "print"};
    words.constants = {"true", "false", "frame", "time"};
    for (const Constant& constant : all_constants()) words.constants.emplace(constant.name);
    for (const BlockInfo& block : all_blocks())
        for (const std::string_view word : {block.keyword, block.kind})
            if (!word.empty()) words.blocks.emplace(word);
    const auto is_taken = [&](const std::string& word) {
        return words.statements.contains(word) || words.constants.contains(word) ||
               words.blocks.contains(word) || words.properties.contains(word) ||
               words.functions.contains(word);
    };
    const auto add = [&](std::set<std::string>& to, std::string_view word) {
        if (!word.empty() && !is_taken(std::string(word))) to.emplace(word);
    };
    for (const BlockInfo& block : all_blocks())
        for (const auto& fields : {block.own, block.shared})
            for (const Field& field : fields) add(words.properties, field.name);
    for (const Function& function : all_functions()) add(words.functions, function.name);
    for (const BlockInfo& block : all_blocks())
        for (const auto& fields : {block.own, block.shared})
            for (const Field& field : fields)
                for (const std::string_view word : field.words) add(words.values, word);
    return words;
}

}  // namespace lancer::cli
