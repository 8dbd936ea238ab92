// Standard output: results, and the text for people where no result claims it for itself.
#pragma once

#include <string_view>

namespace lancer::cli {

class StandardOutput {
  public:
    /// From now on only results go to standard output, and what is said to standard error.
    void reserve() { reserved_ = true; }

    /// A result. Throws FileError when it cannot be written.
    void put(std::string_view text);

    /// Text for people: a table's row, a closing line. It is seen at once. Throws FileError when
    /// standard output cannot be written; what standard error does not take is lost.
    void say(std::string_view text);

    /// To be called at the end of the program, for what the system has not been given yet. Throws
    /// FileError, unless another call has done so before.
    void finish();

  private:
    [[noreturn]] void fail();

    bool failed_ = false;
    bool reserved_ = false;
};

}  // namespace lancer::cli
