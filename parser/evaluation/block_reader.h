// Reads the properties of one block into plain structs, by its table of fields.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "parser/ast.h"
#include "parser/evaluation/block_context.h"
#include "parser/evaluation/files.h"
#include "parser/scene_builder.h"

namespace lancer {

class BlockReader {
  public:
    BlockReader(const BlockContext& context, const ast::File& file, const ast::Statement& block,
                const BlockWord& word);

    /// Reads every property into the struct its table is for: `own` for the block's own fields,
    /// `shared` for those it shares. Returns false after an error, each reported; then the block is
    /// not to be used.
    bool read(void* own, void* shared = nullptr);

    /// Checks all that shows without evaluating: unknown, missing and repeated properties.
    void check();

    /// Whether a property was given, and where its value stands (the block's word, if not given).
    bool has(std::string_view property) const { return find(property) != nullptr; }
    SourceSpan place(std::string_view property) const;
    SourceSpan place() const { return file_.span(block_); }

    /// Reports an error about the block and makes it unusable.
    template <class... Args>
    Diagnostic* error(Message message, const SourceSpan& where, const Args&... args) {
        good_ = false;
        return context_.report.error(message, where, args...);
    }
    template <class... Args>
    void warning(Message message, const SourceSpan& where, const Args&... args) {
        context_.report.warning(message, where, args...);
    }
    bool good() const { return good_; }

    const BlockContext& context() const { return context_; }
    Report& report() { return context_.report; }
    SceneBuilder& builder() { return context_.builder; }
    Meter& meter() { return context_.meter; }
    const BlockWord& word() const { return word_; }
    /// The second word: a camera's, material's or texture's name.
    std::string_view name() const;
    SourceSpan name_place() const { return file_.name_span(block_); }
    /// A file name in the script as a path.
    std::string resolve_path(std::string_view path) const {
        return context_.files.resolve_path(file_, path);
    }

  private:
    struct Given {
        const ast::Statement* statement = nullptr;
    };
    const ast::Statement* find(std::string_view property) const;
    void report_unknown(const ast::Statement& statement);
    void read_statement(const ast::Statement& statement, void* own, void* shared);

    const BlockContext& context_;
    const ast::File& file_;
    const ast::Statement& block_;
    const BlockWord& word_;
    std::vector<Given> given_;                ///< by index of the property
    std::vector<std::string_view> misspelt_;  ///< properties that were probably meant
    bool good_ = true;
    bool evaluates_ = true;
};

/// Value of a property by its table, with all errors reported. False: do not use it.
bool read_property(const BlockContext& context, const ast::File& file,
                   const ast::Statement& property, const Field& field, void* owner);

/// The material of a shape or group that holds it itself; `none` after an error.
std::uint32_t make_inline_material(const BlockContext& context, const ast::File& file,
                                   const ast::Statement& statement);

/// What a block becomes. `result`, for materials and textures, is the index of what was made.
using MakeBlock = void (*)(BlockReader& block, std::uint32_t& result);
/// By keyword and, for lights, kind.
MakeBlock maker_of(const BlockInfo& block);

}  // namespace lancer
