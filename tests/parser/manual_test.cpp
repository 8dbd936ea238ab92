// docs/language.md lists every block, property, function and constant as in the tables.
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <string>

#include "model/io/file.h"
#include "parser/field.h"
#include "parser/functions.h"

namespace lancer {
namespace {

std::string manual() {
    return io::read_file(std::string(LANCER_SOURCE_DIR) + "/docs/language.md");
}

/// The table of some fields as it stands in the manual.
std::string table(std::span<const Field> fields) {
    std::string text = "| property | takes | without it | |\n|---|---|---|---|\n";
    for (const Field& field : fields) {
        text += "| `" + std::string(field.name) + "` | " + std::string(field.takes) + " | " +
                (field.standard == required ? "**required**" : std::string(field.standard)) +
                " | " + std::string(field.doc) + " |\n";
    }
    return text;
}

/// Expects the text in the manual; the failure shows the expected text.
void expect_in_manual(const std::string& text) {
    EXPECT_NE(manual().find(text), std::string::npos) << text;
}

TEST(Manual, HasTheTableOfEveryBlock) {
    for (const BlockInfo& block : all_blocks()) {
        if (!block.own.empty()) expect_in_manual(table(block.own));
        if (!block.shared.empty()) expect_in_manual(table(block.shared));
        if (!block.keyword.empty())
            expect_in_manual("`" + std::string(block.keyword) +
                             (block.kind.empty() ? "" : " " + std::string(block.kind)) + "`");
    }
}

TEST(Manual, HasEveryFunctionAndConstant) {
    std::string text = "| function | |\n|---|---|\n";
    for (const Function& f : all_functions())
        text += "| `" + std::string(f.name) + "(" + std::string(f.parameters) + ")` | " +
                std::string(f.doc) + " |\n";
    expect_in_manual(text);
    for (const Constant& constant : all_constants())
        expect_in_manual("`" + std::string(constant.name) + "`");
}

}  // namespace
}  // namespace lancer
