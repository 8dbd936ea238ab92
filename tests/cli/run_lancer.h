// Runs the program as a user does, without a shell, and collects its output.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

#include "model/image.h"

namespace lancer::cli {

struct Finished {
    int code = -1;  ///< exit code; 128 + n when signal n ended it
    std::string out;
    std::string err;
};

/// The destination of standard output when it cannot be read back.
enum class BrokenOutput {
    full,         ///< a device without room
    closed_pipe,  ///< a pipe that nobody reads
    closed,       ///< nothing is open
};

/// The inputs of a run beside its arguments.
struct Surroundings {
    std::string input{};                   ///< on standard input
    std::vector<std::string> variables{};  ///< NAME=value, on top of this process's environment
    std::optional<BrokenOutput> output{};
    std::string limits{};          ///< for the shell's `ulimit`, as in "-v 100000 -s 1000"
    bool ignores_signals = false;  ///< SIGINT and SIGTERM, as below nohup
};

/// The program under test.
const char* lancer_program();

/// A temporary folder that the destructor removes. The program runs in it.
class Workplace {
  public:
    Workplace();
    ~Workplace();
    Workplace(const Workplace&) = delete;
    Workplace& operator=(const Workplace&) = delete;

    /// Runs `lancer ARGUMENTS…` with `input` on its standard input. `variables` (NAME=value) come
    /// on top of this process's environment.
    Finished run(std::vector<std::string> arguments, const std::string& input = "",
                 const std::vector<std::string>& variables = {}) const;
    Finished run_in(const Surroundings& surroundings, std::vector<std::string> arguments) const;

    /// The same in two steps, for tests that act between them.
    pid_t start(const Surroundings& surroundings, std::vector<std::string> arguments) const;
    Finished finish(pid_t child) const;

    std::string path(const std::string& name) const { return folder_ + "/" + name; }
    void write(const std::string& name, const std::string& text) const;
    std::string read(const std::string& name) const;
    bool exists(const std::string& name) const;
    std::vector<std::string> files() const;  ///< sorted names
    Image image(const std::string& name) const;

  private:
    std::string folder_;
};

/// A small scene: a ball and a box on a floor with a shadow, `param size`, 64 x 48 pixels.
std::string small_scene();

}  // namespace lancer::cli
