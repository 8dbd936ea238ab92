// Files and folders that exist only while something is being made.
#pragma once

#include <filesystem>
#include <string>

namespace lancer::io {

/// A new, empty file that is gone when the object is, unless `keep_as` was called. It has no name
/// where the file system allows that (O_TMPFILE), so that not even a killed process leaves it
/// behind; elsewhere the next run that writes into the folder removes it.
class TemporaryFile {
  public:
    enum class Naming {
        if_needed,  ///< only where the file system has no files without a name
        always,
    };

    /// Creates the file in `folder` (empty: the current one) with the access rights of an ordinary
    /// new file; its name, if it gets one, ends in `ending`. Throws FileError, whose message names
    /// `purpose`.
    TemporaryFile(const std::string& folder, const std::string& ending, const std::string& purpose,
                  Naming naming = Naming::if_needed);
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    /// To open the file by; without a name of its own it is one below /proc, which holds as long as
    /// this object does, for other processes of the same user too.
    const std::string& name() const { return name_; }
    int descriptor() const { return descriptor_; }

    /// Makes it the file `path`, replacing what was there in one step. To be called once, at the
    /// end. Throws FileError, which also tells of bytes that could not be stored.
    void keep_as(const std::string& path);

  private:
    bool open_unnamed();
    void open_named(const std::string& ending, const std::string& purpose);

    std::string folder_;
    std::string name_;
    int descriptor_ = -1;
    bool has_name_ = false;  ///< in the folder, so that it has to be removed
    int slot_ = -1;          ///< see temporary_registry.h
};

/// A fresh directory below the temporary one, removed with all it holds at the end of its life; the
/// next run removes what a killed one left. Throws FileError when none can be made.
class TemporaryFolder {
  public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
    int descriptor_ = -1;  ///< holds the lock that says it is in use
    int slot_ = -1;
};

}  // namespace lancer::io
