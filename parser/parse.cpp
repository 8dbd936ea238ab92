#include "parser/parse.h"

#include <algorithm>

#include "model/io/file.h"
#include "model/io/texture_file.h"
#include "parser/advice.h"
#include "parser/evaluation/evaluator.h"
#include "parser/program.h"
#include "parser/syntax.h"
#include "parser/vertex_colors.h"

namespace lancer {

Script::Script() = default;
Script::Script(Script&&) noexcept = default;
Script& Script::operator=(Script&&) noexcept = default;
Script::~Script() = default;

void Script::forget() {
    program.reset();
}

Loader disk_loader(int threads) {
    return {
        [](const std::string& path, std::size_t limit) { return io::read_file(path, limit); },
        [threads](const std::string& path) { return io::read_mesh(path, {.threads = threads}); },
        [](const std::string& path, io::ColorSpace space) {
            return io::read_texture(path, space);
        }};
}

std::uint32_t add_source(SourceMap& sources, std::string name, std::string text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
    return sources.add(std::move(name), std::move(text));
}

Script parse_script(const std::string& name, std::string text, const Limits& limits,
                    SourceMap& sources, std::vector<Diagnostic>& found) {
    Script script;
    script.program = std::make_unique<Program>();
    Program& program = *script.program;
    Report report(found, limits.errors);
    constexpr std::uint64_t longest = 0xFFFFFFFE;  // offsets are 32 bits wide
    const std::uint64_t most = std::min(limits.source_bytes, longest);
    const bool too_long = text.size() > most;
    if (too_long) text.clear();
    script.file = add_source(sources, name, std::move(text));
    program.main.source = script.file;
    try {
        if (too_long) report.error(Message::source_limit, {script.file, 0, 0}, most);
        program.main = read_syntax(script.file, sources, program.symbols, program.vocabulary,
                                   limits.nesting, report);
    } catch (const StopReading&) {
    }
    return script;
}

Evaluation evaluate(const Script& script, const Definitions& definitions, const Limits& limits,
                    SourceMap& sources, std::vector<Diagnostic>& found, const Loader& loader) {
    Evaluation result;
    Report report(found, limits.errors);
    Report usage(result.usage_errors, limits.errors);
    try {
        Evaluator evaluator(*script.program, definitions, limits, sources, report, loader);
        try {
            std::vector<std::pair<Symbol, Value>> defined;
            if (!definitions.values.empty())
                defined = Evaluator(*script.program, definitions, limits, sources, usage, loader)
                              .evaluate_definitions();
            evaluator.define(defined);
            evaluator.run();
            evaluator.check_unreached();
            evaluator.check_definitions(usage);
        } catch (const StopReading&) {
        }
        result.scene = evaluator.take_scene();
        if (!report.any_error()) check_vertex_colors(result.scene, report);
        if (!report.any_error())
            for (Diagnostic& warning : advice_on(result.scene, evaluator.builder().pieces))
                found.push_back(std::move(warning));
        // Sorts the diagnostics by their places in the text, whichever stage found them.
        const auto key = [](const Diagnostic& d) {
            return std::pair(d.where.file, d.where.offset);
        };
        std::stable_sort(found.begin(), found.end(),
                         [&](const auto& a, const auto& b) { return key(a) < key(b); });
        result.printed = evaluator.take_printed();
    } catch (const StopReading&) {
    }
    return result;
}

}  // namespace lancer
