// Tells whether two names belong to the same file.
#pragma once

#include <string>

namespace lancer::io {

struct FileIdentity {
    /// Equal for two names of one file, also through symbolic and hard links and through folders
    /// that are mounted twice. A file that does not exist yet is identified by its folder and name.
    /// The text has no other meaning.
    std::string key;
    /// Whether this is an ordinary file, or none yet. Devices and pipes have a key, too, but output
    /// to them does not replace the input from them.
    bool is_ordinary = true;
};

/// The identity of the file that opening `path` would use.
FileIdentity identity_of(const std::string& path);

/// The same for an open descriptor, such as standard output.
FileIdentity identity_of(int descriptor);

}  // namespace lancer::io
