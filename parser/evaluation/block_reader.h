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

    /// Reads every property into the struct that its table belongs to: `own` for the block's own
    /// fields, `shared` for those that it shares with other blocks. Returns false after an error,
    /// which was reported; then the block must not be used.
    bool read(void* own, void* shared = nullptr);

    /// Checks what can be checked without evaluating: unknown, missing and repeated properties.
    void check();

    /// `has`: whether the property was given. `place`: the place of its value, or of the block's
    /// word when it was not given.
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
    /// The second word: the name of a camera, material or texture.
    std::string_view name() const;
    SourceSpan name_place() const { return file_.name_span(block_); }
    /// The path that a file name in the script stands for.
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
    std::vector<std::string_view> misspelt_;  ///< properties that misspelt words probably meant
    bool good_ = true;
    bool evaluates_ = true;
};

/// Reads a property's value by its table and reports all errors. False: the value must not be used.
bool read_property(const BlockContext& context, const ast::File& file,
                   const ast::Statement& property, const Field& field, void* owner);

/// The material that a shape or group holds in its own braces; `none` after an error.
std::uint32_t make_inline_material(const BlockContext& context, const ast::File& file,
                                   const ast::Statement& statement);

/// Makes the object that a block describes. `result`, for materials and textures, is its index.
using MakeBlock = void (*)(BlockReader& block, std::uint32_t& result);
/// The function for a block, by its keyword and, for lights, its kind.
MakeBlock maker_of(const BlockInfo& block);

}  // namespace lancer
