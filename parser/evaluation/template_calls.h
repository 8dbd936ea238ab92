// Templates and functions of the script: their definitions, and the calls of templates.
#pragma once

#include <optional>
#include <vector>

#include "parser/evaluation/expressions.h"
#include "parser/evaluation/names.h"
#include "parser/evaluation/parameters.h"

namespace lancer {

class TemplateCalls {
  public:
    TemplateCalls(const Context& context, Names& names, Expressions& expressions)
        : context_(context), names_(names), expressions_(expressions) {}

    /// Executes a `def` or `func` statement.
    void define(const ast::File& file, const ast::Statement& statement);

    /// A called template whose parameters are bound.
    struct Entered {
        const ast::File& file;
        const ast::Statement& definition;
        Scopes::Caller caller;
    };
    /// Enters the template that a statement calls, until leave(). Nothing after an error.
    std::optional<Entered> enter(const ast::File& file, const ast::Statement& call);
    void leave(const Scopes::Caller& caller);

  private:
    bool has_new_parameters(const Parameters& parameters) const;
    const Binding* find_template(const ast::Statement& call, const SourceSpan& place) const;
    bool match(const ast::File& file, const ast::Statement& call, const Parameters& parameters,
               std::vector<Given>& given);
    bool are_complete(const Parameters& parameters, const SourceSpan& call,
                      const std::vector<Given>& given) const;
    void bind(const Parameters& parameters, std::vector<Given>& given);

    const Context context_;
    Names& names_;
    Expressions& expressions_;
};

}  // namespace lancer
