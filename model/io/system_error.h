// The operating system's reason for a failure, as a FileError.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <system_error>

#include "model/diagnostic.h"

namespace lancer::io {

/// "cannot read 'a.obj': No such file or directory"
inline FileError system_error(std::string_view what, const std::string& path, int code) {
    return FileError(fmt::format("{} '{}': {}", what, path, std::generic_category().message(code)));
}

}  // namespace lancer::io
