// Script text → AST → Scene: the public interface of the folder. PEGTL and the AST are private.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/diagnostic.h"
#include "model/io/image_file.h"
#include "model/io/mesh_file.h"
#include "model/scene.h"
#include "model/source.h"

namespace lancer {

struct Program;  // parser/program.h: the AST, the symbols, loaded files

/// Bounds on what a script may cost. Passing one is an ordinary error with a place.
struct Limits {
    std::uint64_t statements = 50'000'000;  ///< executions; an iteration of a loop counts as one
    std::uint64_t calls = 512;              ///< nested calls or includes
    std::uint64_t nesting = 512;            ///< levels of brackets, blocks, operators in the text
    std::uint64_t source_bytes = 64ull << 20;   ///< all files together
    std::uint64_t list_elements = 100'000'000;  ///< made during the whole run
    std::uint64_t objects = 5'000'000;  ///< shapes; as many lights, cameras, materials, textures
    std::uint64_t held_bytes = 1ull << 30;    ///< of lists and strings at one time
    std::uint64_t text_bytes = 256ull << 20;  ///< strings ever made, printed lines included
    std::uint64_t errors = 100;               ///< after which the rest is not reported
};

/// What the command line defines for a script's params.
struct Definitions {
    std::vector<std::pair<std::string, std::string>> values;  ///< -D name=value, in order
    std::optional<double> frame;  ///< of an animation; without one both params are 0
    std::optional<double> time;   ///< 0..1 from the first frame to the last
};

/// How the files that a script names are read; each function throws FileError. Tests and fuzzing
/// have their own.
struct Loader {
    std::function<std::string(const std::string& path, std::size_t limit)> text;
    std::function<io::LoadedMesh(const std::string& path)> mesh;
    std::function<Image(const std::string& path, io::ColorSpace space)> image;
};

/// Reads from disk, by the functions of model/io, large meshes with `threads` threads (0: as many
/// as the machine has).
Loader disk_loader(int threads = 1);

/// A parsed script. Included files are read when the script reaches them. They, meshes and images
/// are kept, so that a second evaluation (the next frame) reads nothing again.
class Script {
  public:
    Script();
    Script(Script&&) noexcept;
    Script& operator=(Script&&) noexcept;
    ~Script();

    void forget();  ///< frees what evaluate() needs; it must not be called afterwards

    std::uint32_t file = 0;  ///< of the main file, in the SourceMap
    std::unique_ptr<Program> program;
};

/// Parses `text` as the script `name`. Messages show this name, and relative file names in the
/// script are relative to it; "-" is standard input, relative to the current folder. Syntax errors
/// are added to `found`; the result holds the statements that could be read.
Script parse_script(const std::string& name, std::string text, const Limits& limits,
                    SourceMap& sources, std::vector<Diagnostic>& found);

/// The result of an evaluation.
struct Evaluation {
    Scene scene;                           ///< usable only when no error was found
    std::vector<std::string> printed;      ///< lines of `print`
    std::vector<Diagnostic> usage_errors;  ///< -D with an unknown name or a bad value: exit code 2
};

/// Runs a script. Errors and warnings are added to `found`. Evaluation goes on after an error as
/// far as possible, so that one run reports all it can. Loads the mesh and image files that the
/// scene names. Writes to `script.program` (the loaded files), so several threads must not share a
/// script.
Evaluation evaluate(const Script& script, const Definitions& definitions, const Limits& limits,
                    SourceMap& sources, std::vector<Diagnostic>& found,
                    const Loader& loader = disk_loader());

}  // namespace lancer
