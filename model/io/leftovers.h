// What killed runs left behind, removed by the next one.
//
// Whoever makes a temporary file or folder holds a lock on it (flock) while it is in use, and the
// system drops the lock when the process ends, however it ends. So a lock that can be had marks
// what nobody uses any more, and process numbers, which come again, play no part.
#pragma once

#include <string>

namespace lancer::io {

/// A new name for a temporary file in `folder` (empty: the current one), which leftovers are known
/// by: `.lancer-PID-COUNT-RANDOM` and the ending.
std::string new_temporary_name(const std::string& folder, const std::string& ending);

/// A pattern for mkdtemp below `parent`, which leftovers are known by.
std::string temporary_folder_pattern(const std::string& parent);

/// Locks an open file or folder until it is closed; false when another process has it, or when the
/// file system has no locks.
bool lock_at_once(int descriptor) noexcept;

/// Removes the user's own unused temporary files from `folder`. Looks once at each folder; a folder
/// that cannot be read is left alone.
void remove_leftover_files(const std::string& folder);

/// The same for temporary folders below `parent`, with all they hold.
void remove_leftover_folders(const std::string& parent);

}  // namespace lancer::io
