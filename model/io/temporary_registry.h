// The names of this process's temporary files and folders, which a signal handler must remove.
#pragma once

#include <string>

namespace lancer::io {

/// Registers `name` for remove_temporary_files and next_temporary_folder; a folder's name must end
/// in '/'. The result is for `forget_temporary`. -1 when there is no room: then the file outlives a
/// signal, and a later run removes it.
int remember_temporary(const std::string& name);

/// To be called when the name no longer exists. -1 does nothing.
void forget_temporary(int slot);

/// Removes every named temporary file of this process, but no folder. Async-signal-safe, for a
/// handler of SIGINT or SIGTERM that then ends the program.
void remove_temporary_files() noexcept;

/// A temporary folder of this process, each returned once; null after the last. Async-signal-safe,
/// for the same handler.
char* next_temporary_folder() noexcept;

}  // namespace lancer::io
