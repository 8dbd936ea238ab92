#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/pages/editors.h"

namespace lancer::cli {
namespace {

using Json = nlohmann::ordered_json;

Json word_rule(const char* name, const std::set<std::string>& words) {
    return {{"name", name}, {"match", fmt::format("\\b(?:{})\\b", fmt::join(words, "|"))}};
}

std::string text(const Json& json) {
    return json.dump(2) + "\n";
}

}  // namespace

std::string vscode_package(const std::string& version) {
    return text(
        {{"name", "lancer"},
         {"displayName", "Lancer scenes"},
         {"description", "Colours scenes of the ray tracer Lancer"},
         {"version", version},
         {"publisher", "lancer"},
         {"license", "MIT"},
         {"engines", {{"vscode", "^1.50.0"}}},
         {"contributes",
          {{"languages", Json::array({{{"id", "lancer"},
                                       {"aliases", Json::array({"Lancer"})},
                                       {"extensions", Json::array({".lancer"})},
                                       {"configuration", "./language-configuration.json"}}})},
           {"grammars", Json::array({{{"language", "lancer"},
                                      {"scopeName", "source.lancer"},
                                      {"path", "./syntaxes/lancer.tmLanguage.json"}}})}}}});
}

std::string vscode_language() {
    const Json pairs =
        Json::array({Json::array({"{", "}"}), Json::array({"[", "]"}), Json::array({"(", ")"})});
    Json closing = pairs;
    closing.push_back(Json::array({"\"", "\""}));
    return text({{"comments", {{"lineComment", "//"}, {"blockComment", Json::array({"/*", "*/"})}}},
                 {"brackets", pairs},
                 {"autoClosingPairs", closing},
                 {"surroundingPairs", closing}});
}

std::string textmate_grammar(const LanguageWords& words) {
    Json rules = Json::array();
    rules.push_back({{"name", "comment.line.double-slash.lancer"}, {"match", "//.*$"}});
    rules.push_back({{"name", "comment.block.lancer"}, {"begin", "/\\*"}, {"end", "\\*/"}});
    rules.push_back({{"name", "string.quoted.double.lancer"},
                     {"begin", "\""},
                     {"end", "\"|$"},
                     {"patterns", Json::array({{{"name", "constant.character.escape.lancer"},
                                                {"match", "\\\\."}}})}});
    rules.push_back({{"name", "constant.other.color.lancer"}, {"match", "#[0-9A-Fa-f]{3,8}\\b"}});
    rules.push_back({{"name", "constant.numeric.lancer"},
                     {"match", "(?<![\\w.])(?:\\d+(?:\\.\\d+)?|\\.\\d+)(?:[eE][-+]?\\d+)?\\b"}});
    rules.push_back(word_rule("keyword.control.lancer", words.statements));
    rules.push_back(word_rule("constant.language.lancer", words.constants));
    rules.push_back(word_rule("entity.name.type.lancer", words.blocks));
    rules.push_back(word_rule("variable.other.property.lancer", words.properties));
    rules.push_back(word_rule("support.constant.lancer", words.values));
    rules.push_back(word_rule("support.function.lancer", words.functions));
    return text({{"name", "Lancer"},
                 {"scopeName", "source.lancer"},
                 {"fileTypes", Json::array({"lancer"})},
                 {"patterns", rules}});
}

}  // namespace lancer::cli
