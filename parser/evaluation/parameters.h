// The parameters of a template or function of the script, and the arguments of a call.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "parser/evaluation/context.h"
#include "parser/scopes.h"

namespace lancer {

/// The argument for one parameter, if there is one.
struct Given {
    Value value;
    bool is_given = false;
};

class Parameters {
  public:
    Parameters(const ast::File& home, const ast::Statement& definition)
        : file_(home), definition_(definition) {}

    std::size_t size() const { return arguments().size(); }
    const ast::Argument& operator[](std::size_t i) const {
        return file_.arguments[arguments().begin + i];
    }
    /// The name of the template or function.
    Symbol name() const { return file_.name_of(definition_); }
    const ast::File& file() const { return file_; }

    /// Gives the parameter `name` a value. False after an error.
    bool give(Symbol name, Value value, std::vector<Given>& given, const SourceSpan& place,
              const Context& context) const;

  private:
    const ast::Range& arguments() const { return file_.parts_of(definition_).arguments; }
    void report_unknown(Symbol name, const SourceSpan& place, const Context& context) const;

    const ast::File& file_;
    const ast::Statement& definition_;
};

/// The binding of a parameter to its value, in the scope of a call.
inline Binding parameter_binding(const ast::File& home, const ast::Argument& parameter,
                                 Value value) {
    Binding binding;
    binding.name = parameter.name;
    binding.place = home.span(parameter);
    binding.value = std::move(value);
    return binding;
}

}  // namespace lancer
