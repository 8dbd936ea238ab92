// Writes the words of the language as a dictionary of libFuzzer, one in quotes a line.
#include <cstdio>
#include <set>
#include <string>
#include <string_view>

#include "parser/field.h"
#include "parser/functions.h"

int main() {
    std::set<std::string_view> words{"include", "let",  "param", "def",   "func",
                                     "for",     "in",   "if",    "else",  "assert",
                                     "print",   "true", "false", "frame", "time"};
    for (const lancer::BlockInfo& block : lancer::all_blocks()) {
        words.insert({block.keyword, block.kind});
        for (const auto& part : {block.own, block.shared}) {
            for (const lancer::Field& field : part) {
                words.insert(field.name);
                words.insert(field.words.begin(), field.words.end());
            }
        }
    }
    for (const lancer::Function& function : lancer::all_functions()) words.insert(function.name);
    for (const lancer::Constant& constant : lancer::all_constants()) words.insert(constant.name);
    words.erase("");
    for (const std::string_view word : words)
        std::printf("\"%.*s \"\n", static_cast<int>(word.size()), word.data());
    // Typical values, blocks and statements, and pieces that are not allowed anywhere.
    for (const char* piece : {"[0, 0, 1]",
                              "[1, 2]",
                              "[[0, 0], [1, 0], [0, 1]]",
                              "[[0, 1, 2]]",
                              "[for i in 0..3: ",
                              "material { ",
                              "texture { ",
                              "#ff8000",
                              "1e308",
                              "1e-308",
                              "0..3",
                              " { ",
                              " } ",
                              "(",
                              ")",
                              "[",
                              "]",
                              " = ",
                              "==",
                              "!=",
                              "<=",
                              ">=",
                              "&&",
                              "||",
                              " ? ",
                              " : ",
                              "^",
                              ".x",
                              "//",
                              "/*",
                              "*/",
                              "\\\"a\\\"",
                              "\\x0a",
                              "\\x0d",
                              "\\x00",
                              "\\xc3\\xb6"})
        std::printf("\"%s\"\n", piece);
}
