// The meaning of names: one lexical scope for let, param, def, material and texture.
//
// Templates and functions see the names of the place where they were written. They are not values,
// so a caller is always inside the scope that holds the definition. Hence all scopes that a body
// can see are still open, and one stack of bindings serves them all. Each name knows its newest
// binding. A binding counts when its scope is the one that the running code sees at that depth
// ("display", Dijkstra), and when it was made before the template or function that is running.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "parser/ast.h"
#include "parser/value.h"

namespace lancer {

struct Binding {
    enum class Kind : std::uint8_t { value, definition, function, broken_definition };

    Kind kind = Kind::value;
    Symbol name = no_symbol;
    Value value;
    const ast::File* file = nullptr;             ///< of a template or function
    const ast::Statement* definition = nullptr;  ///< of a template or function
    SourceSpan place;                            ///< of the name in its definition
    std::uint32_t scope = 0;                     ///< set by bind()
    std::uint32_t depth = 0;                     ///< set by bind()
    std::uint32_t previous = 0;  ///< set by bind(): the previous binding of the name
};

class Scopes {
  public:
    void open();
    void close();

    /// Adds to the innermost scope. The name must be new there: see find_here().
    void bind(Binding binding);
    /// Gives the newest binding of all, which is in the innermost scope, a new value.
    void rebind(Value value) { bindings_.back().value = std::move(value); }
    /// The meaning of a name here; nullptr when there is none. Valid until the next bind() or
    /// close().
    const Binding* find(Symbol name) const;
    /// The template or function that a call of this name means here.
    const Binding* find_callable(Symbol name) const;
    /// The binding of the name in the innermost scope itself.
    const Binding* find_here(Symbol name) const;

    /// Calls `visit(symbol)` for each name that can be seen from here.
    template <class Visit>
    void for_each_visible(Visit visit) const {
        for (std::uint32_t i = 1; i < bindings_.size(); ++i)
            if (is_visible(i)) visit(bindings_[i]);
    }

    /// The state that leave() restores for the caller.
    struct Caller {
        std::uint32_t depth = 0;
        std::uint32_t template_depth = 0;
        std::uint32_t limit = 0;
    };
    /// Makes the names visible that the body of the template or function sees. The caller must then
    /// open a scope for its parameters.
    Caller enter(const Binding& definition);
    void leave(const Caller& caller);

  private:
    static constexpr std::uint32_t unlimited = 0xFFFFFFFF;

    struct Level {
        std::uint32_t scope = unlimited;
        std::uint32_t limit = unlimited;  ///< bindings from this index on were made later
    };
    struct Scope {
        std::uint32_t first_binding = 0;
        Level overwritten;
    };

    bool is_visible(std::uint32_t index) const {
        const Binding& b = bindings_[index];
        return b.depth <= depth_ && display_[b.depth].scope == b.scope &&
               index < display_[b.depth].limit;
    }

    std::vector<Binding> bindings_{Binding{}};  ///< the first means: none
    std::vector<std::uint32_t> newest_;         ///< by symbol; 0: none
    std::vector<Scope> scopes_;
    std::vector<Level> display_{Level{}};
    std::uint32_t depth_ = 0;
};

}  // namespace lancer
