// The values that expressions work on, and the names of those that are named arguments.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "parser/ast.h"
#include "parser/value.h"

namespace lancer {

class ValueStack {
  public:
    /// The name of an argument.
    struct Label {
        std::size_t argument = 0;  ///< its place on the stack
        const ast::Step* step = nullptr;
    };

    std::size_t size() const { return values_.size(); }
    Value& operator[](std::size_t place) { return values_[place]; }
    Value& top() { return values_.back(); }
    Value& below_top() { return values_[values_.size() - 2]; }
    std::span<Value> from(std::size_t first) { return std::span(values_).subspan(first); }

    void push(const Value& value) { values_.push_back(value); }
    void push(Value&& value) { values_.push_back(std::move(value)); }
    void push_broken() { values_.emplace_back(); }
    Value pop() {
        Value value = std::move(values_.back());
        values_.pop_back();
        return value;
    }

    void drop() { values_.pop_back(); }

    /// Drops all values from `first` on, with their names.
    void cut(std::size_t first) {
        values_.resize(first);
        while (!labels_.empty() && labels_.back().argument >= first) labels_.pop_back();
    }
    /// Pushes broken values up to this size.
    void fill_up(std::size_t size) { values_.resize(size); }
    /// Frees unused memory.
    void shrink() { values_.shrink_to_fit(); }

    /// Names the value on top.
    void name_top(const ast::Step& step) { labels_.push_back({values_.size() - 1, &step}); }
    /// The names of the values from `first` on, in order.
    std::span<const Label> labels_from(std::size_t first) const {
        std::size_t label = labels_.size();
        while (label > 0 && labels_[label - 1].argument >= first) --label;
        return std::span(labels_).subspan(label);
    }

  private:
    std::vector<Value> values_;
    std::vector<Label> labels_;
};

}  // namespace lancer
