// The operating system's reason for a failure, as a FileError.
#pragma once

#include <fmt/format.h>

#include <cerrno>
#include <string>
#include <string_view>
#include <system_error>

#include "model/diagnostic.h"

namespace lancer::io {

/// A FileError with its error number.
struct SystemError : FileError {
    SystemError(const std::string& message, int number) : FileError(message), code(number) {}
    int code;  ///< as in errno

    /// Whether the failure may be temporary: trouble of a network or of another process, which may
    /// be gone at the next attempt or on another machine. A full disk or missing rights must be
    /// corrected by a person.
    bool may_pass() const {
        switch (code) {
            case ESTALE:
            case ETIMEDOUT:
            case EIO:
            case EREMOTEIO:
            case ENETDOWN:
            case ENETUNREACH:
            case EHOSTDOWN:
            case EHOSTUNREACH:
            case ECONNRESET:
            case EAGAIN:
            case EBUSY:
            case ENFILE:
                return true;
            default:
                return false;
        }
    }
};

/// "cannot read 'a.obj': No such file or directory"
inline SystemError system_error(std::string_view what, const std::string& path, int code) {
    return {fmt::format("{} '{}': {}", what, path, std::generic_category().message(code)), code};
}

}  // namespace lancer::io
