#include "cli/standard_output.h"

#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>

#include "model/diagnostic.h"

namespace lancer::cli {

void StandardOutput::fail() {
    failed_ = true;
    throw FileError("cannot write standard output: " + std::generic_category().message(errno));
}

void StandardOutput::put(std::string_view text) {
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) fail();
}

void StandardOutput::say(std::string_view text) {
    if (reserved_) {
        std::fwrite(text.data(), 1, text.size(), stderr);
        return;
    }
    put(text);
    finish();
}

void StandardOutput::finish() {
    if (std::fflush(stdout) != 0 && !failed_) fail();
}

}  // namespace lancer::cli
