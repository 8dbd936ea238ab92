#include "cli/session.h"

#include "model/io/file.h"

namespace lancer::cli {

void Session::will_write(const std::string& path, const std::string& option) {
    files.add_output(path, option);
    if (files.takes_standard_output()) output.reserve();
}

void Session::write(const std::string& path, const std::string& bytes) {
    if (path == "-") {
        output.put(bytes);
    } else if (!path.empty()) {
        io::write_file(path, bytes);
    }
}

}  // namespace lancer::cli
