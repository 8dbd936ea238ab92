// Runs the program as a user does, without a shell, and brings back all it said.
#pragma once

#include <string>
#include <vector>

#include "model/image.h"

namespace lancer::cli {

struct Finished {
    int code = -1;  ///< exit code; 128 + n when signal n ended it
    std::string out;
    std::string err;
};

/// A folder of its own below the temporary one, gone when the object is. The program runs in it.
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
