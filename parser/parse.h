// Script text → AST → Scene. The folder's public face; PEGTL and the AST stay behind it.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "model/diagnostic.h"
#include "model/scene.h"
#include "model/source.h"

namespace lancer {

namespace ast {
struct File;
}

/// Bounds on what a script may cost; passing one is an ordinary error at its place.
struct Limits {
    std::uint64_t statements = 50'000'000;      ///< executions; an iteration of a loop counts as one
    std::uint64_t calls = 512;                  ///< nested calls or includes
    std::uint64_t nesting = 512;                ///< levels of brackets, blocks, operators in the text
    std::uint64_t source_bytes = 64ull << 20;   ///< all files together
    std::uint64_t list_elements = 100'000'000;  ///< ever made
    std::uint64_t objects = 5'000'000;
};

/// What the command line says about a script's params.
struct Definitions {
    std::vector<std::pair<std::string, std::string>> values;  ///< -D name=value, in order
    double frame = 0;
    double time = 0;
};

/// A parsed script, without the files that it includes: those are read when they are met.
class Script {
  public:
    Script();
    Script(Script&&) noexcept;
    Script& operator=(Script&&) noexcept;
    ~Script();

    std::uint32_t file = 0;  ///< of the main file, in the SourceMap
    std::unique_ptr<ast::File> syntax;
};

/// Reads `text` as a script called `name` (what messages show, and what relative names in it are
/// relative to; "-" is standard input, relative to the current folder). Syntax errors are added to
/// `found`, and the statements that could be read are in the result all the same.
Script parse_script(const std::string& name, std::string text, const Limits& limits,
                    SourceMap& sources, std::vector<Diagnostic>& found);

/// What an evaluation brings beside the scene.
struct Evaluation {
    Scene scene;  ///< usable only when no error was found
    std::vector<std::string> printed;           ///< lines of `print`
    std::vector<Diagnostic> usage_errors;       ///< -D with an unknown name or a bad value: exit code 2
};

/// Runs a script. Errors and warnings are added to `found`; evaluation goes on after an error as far
/// as it makes sense, so that one run reports all it can. Loads the mesh and image files that the scene names.
Evaluation evaluate(const Script& script, const Definitions& definitions, const Limits& limits,
                    SourceMap& sources, std::vector<Diagnostic>& found);

}  // namespace lancer
