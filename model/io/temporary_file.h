// Temporary files and folders.
#pragma once

#include <filesystem>
#include <string>

namespace lancer::io {

/// A new, empty file that the destructor removes, unless `keep_as` was called. If the file system
/// allows it (O_TMPFILE), the file has no name, so that not even a killed process leaves it behind.
/// Otherwise the next run that writes into the folder removes it.
class TemporaryFile {
  public:
    enum class Naming {
        if_needed,  ///< only where the file system has no files without a name
        always,
    };

    /// Creates the file in `folder` (empty: the current one) with the access rights of an ordinary
    /// new file. Its name, if it gets one, ends in `ending`. Throws FileError, whose message names
    /// `purpose`.
    TemporaryFile(const std::string& folder, const std::string& ending, const std::string& purpose,
                  Naming naming = Naming::if_needed);
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    /// A name for opening the file. If the file has no name of its own, this is a name below /proc,
    /// which other processes of the same user can use, too, as long as this object exists.
    const std::string& name() const { return name_; }
    int descriptor() const { return descriptor_; }

    /// Gives the file the name `path` and replaces an existing file atomically. To be called once,
    /// at the end. Throws FileError, also for bytes that could not be stored.
    void keep_as(const std::string& path);

  private:
    bool open_unnamed();
    void open_named(const std::string& ending, const std::string& purpose);

    std::string folder_;
    std::string name_;
    int descriptor_ = -1;
    bool has_name_ = false;  ///< the name is in the folder, so it must be removed
    int slot_ = -1;          ///< see temporary_registry.h
};

/// A new directory below the temporary one. The destructor removes it with its content; the next
/// run removes one that a killed process left. Throws FileError when none can be made.
class TemporaryFolder {
  public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
    int descriptor_ = -1;  ///< holds the lock that marks it as in use
    int slot_ = -1;
};

}  // namespace lancer::io
