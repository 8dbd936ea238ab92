// All that a run reads and all that it writes, in one place, so that nothing which is read is
// written over, and no output over another.
#pragma once

#include <map>
#include <set>
#include <string>

namespace lancer::cli {

class RunFiles {
  public:
    /// Knows standard output where it is an ordinary file (`> name`).
    RunFiles();

    /// A file that is about to be read; `-` is standard input. Throws UsageError when an output
    /// would be written over it.
    void add_input(const std::string& path);

    /// A file that will be written, and what asks for it, as in "--json"; `-` is standard output,
    /// an empty name no file at all. Throws UsageError when it is an input or another option's
    /// output, and FileError when it cannot be written. To be called before the work begins.
    void add_output(const std::string& path, const std::string& option);

    /// The same for a file in a folder that is made when it is missing.
    void add_output_in_new_folder(const std::string& path, const std::string& option);

    /// Whether one of the outputs is standard output.
    bool takes_standard_output() const { return takes_standard_output_; }

  private:
    struct Output {
        std::string name;
        std::string option;  ///< empty: text for people, on standard output
    };
    void enter_output(const std::string& path, const std::string& option);
    void check_writable(const std::string& path);
    void check_folder(const std::string& folder, const std::string& path);

    std::map<std::string, std::string> inputs_;  ///< by io::FileIdentity::key, the names
    std::map<std::string, Output> outputs_;
    std::set<std::string> writable_folders_;
    std::string standard_output_;  ///< its key
    bool takes_standard_output_ = false;
};

}  // namespace lancer::cli
