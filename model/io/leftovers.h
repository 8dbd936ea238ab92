// Removes temporary files that killed runs left behind.
//
// The process that makes a temporary file or folder holds a lock on it (flock) while it is in use.
// The system releases the lock when the process ends, however it ends. So a lock that can be taken
// marks an unused file. Process numbers do not matter, since the system uses them again.
#pragma once

#include <string>

namespace lancer::io {

/// A new name for a temporary file in `folder` (empty: the current one), recognizable as a
/// leftover: `.lancer-PID-COUNT-RANDOM` and the ending.
std::string new_temporary_name(const std::string& folder, const std::string& ending);

/// A pattern for mkdtemp below `parent`, recognizable as a leftover.
std::string temporary_folder_pattern(const std::string& parent);

/// Locks an open file or folder until it is closed. False when another process has the lock, or
/// when the file system has no locks.
bool lock_at_once(int descriptor) noexcept;

/// Removes the user's own unused temporary files from `folder`. Examines each folder once; ignores
/// a folder that cannot be read.
void remove_leftover_files(const std::string& folder);

/// The same for temporary folders below `parent`, with their content.
void remove_leftover_folders(const std::string& parent);

}  // namespace lancer::io
