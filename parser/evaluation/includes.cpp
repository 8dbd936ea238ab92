#include "parser/evaluation/includes.h"

#include <algorithm>
#include <filesystem>

#include "parser/syntax.h"

namespace lancer {

Includes::Includes(const Context& context, Files& files) : context_(context), files_(files) {
    including_.push_back(identity(context.sources.name(context.program.main.source)));
}

const ast::File* Includes::enter(const ast::File& file, const ast::Statement& statement,
                                 const Value& name) {
    const SourceSpan place = file.span(statement.value);
    if (name.is_broken()) return nullptr;
    if (!name.is(Value::Kind::text)) {
        context_.report.error(Message::include_type, place, describe(name));
        return nullptr;
    }
    const std::string path = files_.resolve_path(file, name.text());
    const std::string key = identity(path);
    if (is_cycle(key, place)) return nullptr;
    if (!included_.insert(key).second) return nullptr;
    const ast::File* included = load(path, key, place, file.span(statement));
    if (included == nullptr) return nullptr;
    context_.enter_call(file.span(statement), "");
    including_.push_back(key);
    return included;
}

void Includes::leave() {
    context_.leave_call();
    including_.pop_back();
}

bool Includes::is_cycle(const std::string& key, const SourceSpan& place) const {
    const auto at = std::find(including_.begin(), including_.end(), key);
    if (at == including_.end()) return false;
    std::string chain;
    for (auto link = at; link != including_.end(); ++link)
        chain += std::filesystem::path(*link).filename().string() + " -> ";
    chain += std::filesystem::path(key).filename().string();
    context_.report.error(Message::include_cycle, place, chain);
    return true;
}

const ast::File* Includes::load(const std::string& path, const std::string& key,
                                const SourceSpan& place, const SourceSpan& statement) {
    Program& program = context_.program;
    Meter& meter = context_.meter;
    LoadedScript& loaded = program.scripts[key];
    if (loaded.file == nullptr && loaded.problem.empty()) {
        try {
            std::string source = files_.loader().text(path, meter.source_left());
            loaded.bytes = source.size();
            meter.source(loaded.bytes, place);
            const std::uint32_t index = add_source(context_.sources, path, std::move(source));
            loaded.file = std::make_unique<ast::File>();
            // so that syntax errors name this include
            context_.report.calls.push_back({statement, ""});
            *loaded.file = read_syntax(index, context_.sources, program.symbols, program.vocabulary,
                                       meter.limits().nesting, context_.report);
            context_.report.calls.pop_back();
        } catch (const FileError& error) {
            loaded.problem = error.what();
        }
    } else {
        meter.source(loaded.bytes, place);
    }
    if (loaded.file == nullptr) {
        incomplete_ = true;
        files_.report_unreadable(path, place, loaded.problem);
    }
    return loaded.file.get();
}

}  // namespace lancer
