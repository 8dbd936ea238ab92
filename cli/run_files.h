// All inputs and outputs of a run, so that no output replaces an input or another output.
#pragma once

#include <map>
#include <set>
#include <string>

namespace lancer::cli {

class RunFiles {
  public:
    /// Records standard output when it is an ordinary file (`> name`).
    RunFiles();

    /// Adds a file that is about to be read; `-` is standard input. Throws UsageError when an
    /// output would replace it.
    void add_input(const std::string& path);

    /// Adds a file that will be written, and the option that asks for it, such as "--json"; `-` is
    /// standard output, an empty name is no file. Throws UsageError when the file is an input or
    /// another option's output, and FileError when it cannot be written. To be called before the
    /// work begins.
    void add_output(const std::string& path, const std::string& option);

    /// The same for a file in a folder that is created when it is missing.
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
