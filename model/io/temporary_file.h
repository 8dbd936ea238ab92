// Files and folders that exist only while something is being made.
#pragma once

#include <filesystem>
#include <string>

namespace lancer::io {

/// A new, empty file with a name of its own, removed again by the destructor unless `keep_as` was
/// called. Also removed by `remove_temporary_files`.
class TemporaryFile {
  public:
    /// Creates the file in `folder` (empty: the current one) with the access rights of an ordinary
    /// new file; its name ends in `ending`. Throws FileError, whose message names `purpose`.
    TemporaryFile(const std::string& folder, const std::string& ending, const std::string& purpose);
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    const std::string& name() const { return name_; }

    /// Renames the file to `path`, replacing what was there in one step. Throws FileError.
    void keep_as(const std::string& path);

  private:
    std::string name_;
    int slot_ = -1;  ///< in the registry that remove_temporary_files reads; -1: not registered
};

/// A fresh directory below the temporary one, removed with all it holds at the end of its life.
/// Throws FileError when none can be made.
class TemporaryFolder {
  public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
    int slot_ = -1;
};

/// Removes every temporary file of this process, but no folder. Async-signal-safe: for a handler of
/// SIGINT or SIGTERM that ends the program afterwards.
void remove_temporary_files() noexcept;

/// A temporary folder of this process, each given once; null after the last. Async-signal-safe, for
/// the same handler.
char* next_temporary_folder() noexcept;

}  // namespace lancer::io
