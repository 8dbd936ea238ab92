#include "parser/evaluator.h"

#include "parser/suggest.h"
#include "parser/syntax.h"

namespace lancer {

Evaluator::Evaluator(Program& program, const Definitions& definitions, const Limits& limits,
                     SourceMap& sources, Report& report, const Loader& loader)
    : program_(program),
      definitions_(definitions),
      sources_(sources),
      report_(report),
      loader_(loader),
      meter_(limits, report),
      builder_(meter_, report) {
    for (const Function& function : all_functions()) {
        const Symbol symbol = program_.symbols.intern(function.name);
        if (functions_.size() <= symbol) functions_.resize(symbol + 1, nullptr);
        functions_[symbol] = &function;
    }
    for (const Constant& constant : all_constants())
        constants_[program_.symbols.intern(constant.name)] = constant.value;
    constants_[program_.symbols.intern("frame")] = definitions.frame.value_or(0);
    constants_[program_.symbols.intern("time")] = definitions.time.value_or(0);
    including_.push_back(identity(sources.name(program.main.source)));
    meter_.source(sources.text(program.main.source).size(), {program.main.source, 0, 0});
}

std::vector<std::pair<Symbol, Value>> Evaluator::evaluate_definitions() {
    std::vector<std::pair<Symbol, Value>> values;
    for (const auto& [name, source] : definitions_.values) {
        ast::File file;
        file.source = sources_.add("-D " + name, source);
        const ast::Expression expression =
            read_expression(file, sources_, program_.symbols, program_.vocabulary,
                            meter_.limits().nesting, report_);
        values.emplace_back(program_.symbols.intern(name), evaluate(file, expression));
    }
    return values;
}

void Evaluator::define(const std::vector<std::pair<Symbol, Value>>& values) {
    // A param of the script called frame or time follows an animation as the built-in ones do.
    if (definitions_.frame)
        defined_[program_.symbols.intern("frame")] = {Value(*definitions_.frame), true};
    if (definitions_.time)
        defined_[program_.symbols.intern("time")] = {Value(*definitions_.time), true};
    for (const auto& [symbol, value] : values) {
        const bool built_in = text(symbol) == "frame" || text(symbol) == "time";
        if (built_in && value.is_number()) constants_[symbol] = value.number();
        defined_[symbol] = {value, built_in};
    }
}

void Evaluator::check_definitions(Report& usage) {
    if (incomplete_) return;  // the param may stand in a file that could not be read
    for (const auto& [name, source] : definitions_.values) {
        if (defined_.at(program_.symbols.intern(name)).second) continue;
        Diagnostic* error = usage.error(Message::unknown_definition, SourceSpan{}, name);
        if (error == nullptr) continue;
        Suggestion suggestion(name);
        for (const Symbol param : params_) suggestion.consider(text(param));
        error->hint = suggestion.hint();
    }
}

bool Evaluator::is_new_camera(const std::string& name, const SourceSpan& place) {
    if (name.empty()) return true;
    const auto [first, is_new] = camera_places_.emplace(name, place);
    if (is_new) return true;
    Diagnostic* error = report_.error(Message::camera_twice, place, name);
    if (error != nullptr)
        error->notes.insert(error->notes.begin(), Report::note(Message::first_here, first->second));
    return false;
}

std::shared_ptr<const io::LoadedMesh> Evaluator::load_mesh(const std::string& path,
                                                           const SourceSpan& place) {
    auto& loaded = program_.meshes[path];
    if (loaded.content == nullptr && loaded.problem.empty()) {
        try {
            loaded.content = std::make_shared<const io::LoadedMesh>(loader_.mesh(path));
        } catch (const FileError& error) {
            loaded.problem = error.what();
        }
    }
    if (loaded.content == nullptr) report_unreadable(path, place, loaded.problem);
    return loaded.content;
}

const Loaded<Image>& Evaluator::image_at(const std::string& path, io::ColorSpace space) {
    auto& loaded = program_.images[{path, space}];
    if (loaded.content == nullptr && loaded.problem.empty()) {
        try {
            loaded.content = std::make_shared<const Image>(in_color(loader_.image(path, space)));
        } catch (const FileError& error) {
            loaded.problem = error.what();
        }
    }
    return loaded;
}

std::shared_ptr<const Image> Evaluator::load_image(const std::string& path, io::ColorSpace space,
                                                   const SourceSpan& place) {
    const Loaded<Image>& loaded = image_at(path, space);
    if (loaded.content == nullptr) report_unreadable(path, place, loaded.problem);
    return loaded.content;
}

std::shared_ptr<const Image> Evaluator::find_image(const std::string& path, io::ColorSpace space,
                                                   const SourceSpan& place) {
    const Loaded<Image>& loaded = image_at(path, space);
    if (loaded.content == nullptr) report_.warning(Message::mesh_file, place, loaded.problem);
    return loaded.content;
}

void Evaluator::report_unreadable(const std::string& path, const SourceSpan& place,
                                  const std::string& problem) {
    Diagnostic* error = report_.error(Message::file_unreadable, place, problem);
    if (error != nullptr && path.find_first_of("\n\t") != std::string::npos)
        error->hint = "'\\n' and '\\t' in a string are a new line and a tab: write '/', or '\\\\'";
}

}  // namespace lancer
