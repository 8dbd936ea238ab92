#include "model/io/temporary_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>

#include "model/io/leftovers.h"
#include "model/io/system_error.h"
#include "model/io/temporary_registry.h"

namespace lancer::io {
namespace {

constexpr int most_attempts = 100;

/// Whether an open file or folder still has a name. Between its creation and its lock, another run
/// may have removed it as a leftover.
bool is_still_there(int descriptor) {
    struct stat status {};
    return fstat(descriptor, &status) == 0 && status.st_nlink > 0;
}

bool is_same_file(int descriptor, const std::string& name) {
    struct stat open_file {};
    struct stat named_file {};
    return fstat(descriptor, &open_file) == 0 && stat(name.c_str(), &named_file) == 0 &&
           open_file.st_dev == named_file.st_dev && open_file.st_ino == named_file.st_ino;
}

/// Network file systems report a full disk only when a descriptor is closed.
bool is_stored(int descriptor) {
    const int copy = dup(descriptor);
    return copy >= 0 && close(copy) == 0;
}

}  // namespace

TemporaryFile::TemporaryFile(const std::string& folder, const std::string& ending,
                             const std::string& purpose, Naming naming)
    : folder_(folder) {
    remove_leftover_files(folder);
    if (naming == Naming::always || !open_unnamed()) open_named(ending, purpose);
}

bool TemporaryFile::open_unnamed() {
    const char* folder = folder_.empty() ? "." : folder_.c_str();
    descriptor_ = open(folder, O_TMPFILE | O_RDWR | O_CLOEXEC, 0666);
    if (descriptor_ < 0) return false;
    name_ = fmt::format("/proc/{}/fd/{}", getpid(), descriptor_);
    if (is_same_file(descriptor_, name_)) {
        lock_at_once(descriptor_);
        return true;
    }
    close(descriptor_);  // /proc is missing or belongs to another process namespace
    return false;
}

void TemporaryFile::open_named(const std::string& ending, const std::string& purpose) {
    for (int attempt = 0;; ++attempt) {
        name_ = new_temporary_name(folder_, ending);
        descriptor_ = open(name_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor_ >= 0) {
            lock_at_once(descriptor_);
            if (is_still_there(descriptor_)) break;
            close(descriptor_);
            errno = EEXIST;
        }
        if (errno != EEXIST || attempt == most_attempts)
            throw system_error("cannot write", purpose, errno);
    }
    has_name_ = true;
    slot_ = remember_temporary(name_);
}

TemporaryFile::~TemporaryFile() {
    if (has_name_) unlink(name_.c_str());
    forget_temporary(slot_);
    close(descriptor_);
}

void TemporaryFile::keep_as(const std::string& path) {
    if (!is_stored(descriptor_)) throw system_error("cannot write", path, errno);
    if (!has_name_) {
        if (linkat(AT_FDCWD, name_.c_str(), AT_FDCWD, path.c_str(), AT_SYMLINK_FOLLOW) == 0) return;
        if (errno != EEXIST) throw system_error("cannot write", path, errno);
        // A link cannot replace a file, but renaming can; so the file gets a temporary name first.
        const std::string unnamed = name_;
        name_ = new_temporary_name(folder_, "");
        slot_ = remember_temporary(name_);
        if (linkat(AT_FDCWD, unnamed.c_str(), AT_FDCWD, name_.c_str(), AT_SYMLINK_FOLLOW) != 0)
            throw system_error("cannot write", path, errno);
        has_name_ = true;
    }
    if (std::rename(name_.c_str(), path.c_str()) != 0)
        throw system_error("cannot write", path, errno);
    has_name_ = false;
}

TemporaryFolder::TemporaryFolder() {
    std::error_code error;
    const std::string parent = std::filesystem::temp_directory_path(error).string();
    if (error) throw system_error("cannot make", "a temporary folder", error.value());
    remove_leftover_folders(parent);
    for (int attempt = 0;; ++attempt) {
        std::string name = temporary_folder_pattern(parent);
        if (attempt == most_attempts || mkdtemp(name.data()) == nullptr)
            throw system_error("cannot make", "a temporary folder", errno);
        path_ = name;
        descriptor_ = open(name.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        if (descriptor_ >= 0) lock_at_once(descriptor_);
        if (descriptor_ >= 0 && is_still_there(descriptor_)) break;
        if (descriptor_ >= 0) close(descriptor_);
    }
    slot_ = remember_temporary(path_.string() + "/");
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
    forget_temporary(slot_);
    close(descriptor_);
}

}  // namespace lancer::io
