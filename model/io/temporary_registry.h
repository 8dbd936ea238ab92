// The names that a signal handler has to remove: temporary files and folders of this process.
#pragma once

#include <string>

namespace lancer::io {

/// Keeps `name` for remove_temporary_files and next_temporary_folder; a folder's ends in '/'. The
/// result is for `forget_temporary`. -1 when there is no room: then the file merely outlives a
/// signal, and a later run removes it.
int remember_temporary(const std::string& name);

/// To be called when the name is no more. -1 does nothing.
void forget_temporary(int slot);

/// Removes every temporary file of this process that has a name, but no folder. Async-signal-safe:
/// for a handler of SIGINT or SIGTERM that ends the program afterwards.
void remove_temporary_files() noexcept;

/// A temporary folder of this process, each given once; null after the last. Async-signal-safe, for
/// the same handler.
char* next_temporary_folder() noexcept;

}  // namespace lancer::io
