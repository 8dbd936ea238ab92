// Reads whole files, and writes files so that no other process sees an incomplete one.
#pragma once

#include <functional>
#include <string>

#include "model/io/row_functions.h"

namespace lancer::io {

/// Reads the bytes of a file; `-` is standard input. Throws FileError (with the system's reason)
/// when it cannot be read, is a directory, or is longer than `limit` bytes.
std::string read_file(const std::string& path, std::size_t limit = std::size_t(1) << 40);

/// Whether output to `path` is written into the existing file and does not replace it. This holds
/// for a device or a pipe, which cannot be replaced, and for the name of an open file such as
/// /dev/stdout, which must not be.
bool is_stream(const std::string& path);

/// The file that `path` leads to through symbolic links; it need not exist. Throws FileError for a
/// cycle of links.
std::string follow_links(std::string path);

/// Runs `write(temporary)` with the name of a temporary file, then renames that file to `path`
/// atomically, with the access rights of an ordinary new file. After any exception, or when the
/// process is killed, `path` is unchanged. Throws FileError when the folder is missing or not
/// writable.
void write_atomically(const std::string& path,
                      const std::function<void(const std::string& temporary)>& write);

/// write_atomically for bytes that come in pieces. A stream gets them when all have come.
void write_pieces(const std::string& path, const std::function<void(const AddBytes& add)>& give);

/// write_atomically for bytes in memory.
void write_file(const std::string& path, const std::string& bytes);

}  // namespace lancer::io
