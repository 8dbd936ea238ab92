// Whole files: read at once, and written so that nobody sees half of one.
#pragma once

#include <functional>
#include <string>

namespace lancer::io {

/// The bytes of a file; `-` is standard input. Throws FileError (with the system's reason) when it
/// cannot be read, is a directory, or is longer than `limit` bytes.
std::string read_file(const std::string& path, std::size_t limit = std::size_t(1) << 40);

/// Whether what is written to `path` goes into it instead of taking its place: a device or a pipe,
/// which cannot be replaced, or the name of an open file such as /dev/stdout, which must not be.
bool is_stream(const std::string& path);

/// The file that `path` leads to through symbolic links, which need not exist. Throws FileError for
/// links that lead round in a circle.
std::string follow_links(std::string path);

/// Runs `write(temporary)` with a name to open a temporary file by, then makes that file `path`, in
/// one step and with the access rights an ordinary new file has. On any exception, and when the
/// process is killed, `path` keeps what it held. Throws FileError when the folder is missing or not
/// writable.
void write_atomically(const std::string& path,
                      const std::function<void(const std::string& temporary)>& write);

/// write_atomically for bytes in memory.
void write_file(const std::string& path, const std::string& bytes);

}  // namespace lancer::io
