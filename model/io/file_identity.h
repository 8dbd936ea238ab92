// Which file a name leads to, so that two names can be told to be one file.
#pragma once

#include <string>

namespace lancer::io {

struct FileIdentity {
    /// Equal for two names of one file, through links of both kinds and through folders that are
    /// mounted twice. A file that is not there yet is known by its folder and its name. Without
    /// other meaning.
    std::string key;
    /// An ordinary file, or none yet. Devices and pipes have a key too, but what is written to them
    /// does not replace what is read from them.
    bool is_ordinary = true;
};

/// The file that is read or written when somebody opens `path`.
FileIdentity identity_of(const std::string& path);

/// The same for an open descriptor, such as standard output.
FileIdentity identity_of(int descriptor);

}  // namespace lancer::io
