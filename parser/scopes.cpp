#include "parser/scopes.h"

#include <utility>

namespace lancer {

void Scopes::open() {
    ++depth_;
    if (display_.size() <= depth_) display_.resize(depth_ + 1);
    const auto scope = static_cast<std::uint32_t>(scopes_.size());
    scopes_.push_back({static_cast<std::uint32_t>(bindings_.size()), display_[depth_]});
    display_[depth_] = {scope, unlimited};
}

void Scopes::close() {
    const Scope& scope = scopes_.back();
    while (bindings_.size() > scope.first_binding) {
        newest_[bindings_.back().name] = bindings_.back().previous;
        bindings_.pop_back();
    }
    display_[depth_] = scope.overwritten;
    --depth_;
    scopes_.pop_back();
}

void Scopes::bind(Binding binding) {
    if (newest_.size() <= binding.name) newest_.resize(binding.name + std::size_t{64}, 0);
    binding.scope = static_cast<std::uint32_t>(scopes_.size() - 1);
    binding.depth = depth_;
    binding.previous = newest_[binding.name];
    newest_[binding.name] = static_cast<std::uint32_t>(bindings_.size());
    bindings_.push_back(std::move(binding));
}

const Binding* Scopes::find(Symbol name) const {
    if (name >= newest_.size()) return nullptr;
    for (std::uint32_t i = newest_[name]; i != 0; i = bindings_[i].previous)
        if (is_visible(i)) return &bindings_[i];
    return nullptr;
}

const Binding* Scopes::find_callable(Symbol name) const {
    if (name >= newest_.size()) return nullptr;
    for (std::uint32_t i = newest_[name]; i != 0; i = bindings_[i].previous)
        if (bindings_[i].kind != Binding::Kind::value && is_visible(i)) return &bindings_[i];
    return nullptr;
}

const Binding* Scopes::find_here(Symbol name) const {
    if (name >= newest_.size()) return nullptr;
    const std::uint32_t i = newest_[name];
    return i != 0 && bindings_[i].scope == scopes_.size() - 1 ? &bindings_[i] : nullptr;
}

Scopes::Caller Scopes::enter(const Binding& definition) {
    const Caller caller{depth_, definition.depth, display_[definition.depth].limit};
    const auto index = static_cast<std::uint32_t>(&definition - bindings_.data());
    depth_ = definition.depth;
    display_[depth_].limit = index + 1;
    return caller;
}

void Scopes::leave(const Caller& caller) {
    display_[caller.template_depth].limit = caller.limit;
    depth_ = caller.depth;
}

}  // namespace lancer
