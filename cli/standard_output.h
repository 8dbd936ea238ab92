// Standard output: it carries results, or text for people when no result needs it.
#pragma once

#include <string_view>

namespace lancer::cli {

class StandardOutput {
  public:
    /// From now on only results go to standard output; text for people goes to standard error.
    void reserve() { reserved_ = true; }

    /// Writes a result. Throws FileError when that fails.
    void put(std::string_view text);

    /// Writes text for people, such as a row of a table or a closing line, and flushes it. Throws
    /// FileError when standard output cannot be written; text that standard error does not accept
    /// is lost.
    void say(std::string_view text);

    /// To be called at the end of the program: flushes what is left. Throws FileError, unless
    /// another call has already done so.
    void finish();

  private:
    [[noreturn]] void fail();

    bool failed_ = false;
    bool reserved_ = false;
};

}  // namespace lancer::cli
