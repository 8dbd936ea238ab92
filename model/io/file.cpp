#include "model/io/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <string_view>

#include "model/io/descriptor.h"
#include "model/io/system_error.h"
#include "model/io/temporary_file.h"

namespace lancer::io {
namespace {

/// The limit for pipes and devices, which do not report a length; some never end.
constexpr std::size_t limit_without_size = std::size_t(256) << 20;

std::string folder_of(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    return slash == std::string::npos ? "" : path.substr(0, slash + 1);
}

/// The ending, ".png" for "a/b.png". Libraries choose the format of a temporary file by it, too.
std::string ending_of(const std::string& path) {
    const std::string ending = std::filesystem::path(path).extension().string();
    return ending.size() <= 16 ? ending : "";
}

void write_all(int descriptor, std::string_view bytes, const std::string& path) {
    while (!bytes.empty()) {
        const ssize_t written = write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) throw system_error("cannot write", path, errno);
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
}

void append_to(const std::string& path, std::string_view bytes) {
    const Descriptor file(open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC));
    if (file.number() < 0) throw system_error("cannot write", path, errno);
    write_all(file.number(), bytes, path);
}

void refuse_folder(const std::string& path) {
    if (path.empty()) throw system_error("cannot write", path, ENOENT);
    struct stat status {};
    if (path.back() == '/' || (stat(path.c_str(), &status) == 0 && S_ISDIR(status.st_mode)))
        throw system_error("cannot write", path, EISDIR);
}

}  // namespace

std::string follow_links(std::string path) {
    for (int i = 0; i < 40; ++i) {
        std::error_code error;
        const std::filesystem::path target = std::filesystem::read_symlink(path, error);
        if (error) return path;
        path = target.is_absolute() ? target.string() : folder_of(path) + target.string();
    }
    throw system_error("cannot write", path, ELOOP);
}

bool is_stream(const std::string& path) {
    const std::string_view name = path;
    if (name.starts_with("/dev/std") || name.starts_with("/dev/fd/")) return true;
    if (name.starts_with("/proc/") && name.find("/fd/") != std::string_view::npos) return true;
    struct stat status {};
    return stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}

std::string read_file(const std::string& path, std::size_t limit) {
    const bool standard_input = path == "-";
    const std::string shown = standard_input ? "standard input" : path;
    const Descriptor file(standard_input ? STDIN_FILENO : open(path.c_str(), O_RDONLY | O_CLOEXEC));
    struct stat status {};
    if (file.number() < 0 || fstat(file.number(), &status) != 0) {
        throw system_error("cannot read", shown, errno);
    }
    if (S_ISDIR(status.st_mode)) throw system_error("cannot read", shown, EISDIR);

    std::string bytes;
    if (S_ISREG(status.st_mode)) {
        bytes.resize(std::min(limit, static_cast<std::size_t>(status.st_size)) + 1);
    } else {
        limit = std::min(limit, limit_without_size);
        bytes.resize(std::min<std::size_t>(limit, 65536) + 1);
    }
    std::size_t length = 0;
    for (;;) {
        const ssize_t count = read(file.number(), bytes.data() + length, bytes.size() - length);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) throw system_error("cannot read", shown, errno);
        if (count == 0) break;
        length += static_cast<std::size_t>(count);
        if (length > limit) throw system_error("cannot read", shown, EFBIG);
        if (length == bytes.size()) bytes.resize(std::min(2 * length, limit) + 1);
    }
    bytes.resize(length);
    return bytes;
}

void write_atomically(const std::string& path,
                      const std::function<void(const std::string& temporary)>& write) {
    refuse_folder(path);
    if (is_stream(path)) {
        const TemporaryFile temporary(std::filesystem::temp_directory_path().string(),
                                      ending_of(path), path);
        write(temporary.name());
        append_to(path, read_file(temporary.name()));
        return;
    }
    const std::string target = follow_links(path);
    TemporaryFile temporary(folder_of(target), ending_of(path), path);
    write(temporary.name());
    temporary.keep_as(target);
}

void write_pieces(const std::string& path, const std::function<void(const AddBytes& add)>& give) {
    constexpr std::size_t most_waiting = std::size_t(1) << 20;
    refuse_folder(path);
    std::string waiting;
    if (is_stream(path)) {
        give([&](std::string_view piece) { waiting += piece; });
        append_to(path, waiting);
        return;
    }
    const std::string target = follow_links(path);
    TemporaryFile temporary(folder_of(target), ending_of(path), path);
    const auto write_out = [&](std::string_view bytes) {
        write_all(temporary.descriptor(), bytes, path);
    };
    give([&](std::string_view piece) {
        if (waiting.size() + piece.size() < most_waiting) {
            waiting += piece;
            return;
        }
        write_out(waiting);
        waiting.clear();
        write_out(piece);
    });
    write_out(waiting);
    temporary.keep_as(target);
}

void write_file(const std::string& path, const std::string& bytes) {
    write_pieces(path, [&](const AddBytes& add) { add(bytes); });
}

}  // namespace lancer::io
