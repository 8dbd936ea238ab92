#include "model/io/leftovers.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <mutex>
#include <random>
#include <set>
#include <string_view>

namespace lancer::io {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view file_prefix = ".lancer-";
constexpr std::string_view folder_prefix = "lancer-temporary-";
constexpr std::size_t random_letters = 6;  // of mkdtemp

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}
bool is_hexadecimal(char c) {
    return is_digit(c) || (c >= 'a' && c <= 'f');
}

/// Removes the leading letters that `belongs` accepts from `rest`, and returns their number.
std::size_t skip(std::string_view& rest, bool (*belongs)(char)) {
    const auto end = std::find_if_not(rest.begin(), rest.end(), belongs);
    const auto count = static_cast<std::size_t>(end - rest.begin());
    rest.remove_prefix(count);
    return count;
}

bool skip_number_and_dash(std::string_view& rest) {
    if (skip(rest, is_digit) == 0 || !rest.starts_with('-')) return false;
    rest.remove_prefix(1);
    return true;
}

/// Whether new_temporary_name made this name.
bool is_temporary_file(std::string_view name) {
    if (!name.starts_with(file_prefix)) return false;
    name.remove_prefix(file_prefix.size());
    return skip_number_and_dash(name) && skip_number_and_dash(name) &&
           skip(name, is_hexadecimal) == 8 && (name.empty() || name.front() == '.');
}

bool is_temporary_folder(std::string_view name) {
    return name.starts_with(folder_prefix) && name.size() == folder_prefix.size() + random_letters;
}

/// True at the first call for `folder`.
bool is_first_look(const std::string& folder) {
    static std::mutex mutex;
    static std::set<std::string> seen;
    const std::lock_guard lock(mutex);
    return seen.insert(folder).second;
}

/// Calls `remove` for each entry of `folder` of this kind and name that belongs to the user and is
/// not in use, while the entry is locked.
void remove_unused(const std::string& folder, mode_t kind, bool (*is_ours)(std::string_view),
                   void (*remove)(const fs::path&)) {
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
        const fs::path& path = at->path();
        if (!is_ours(path.filename().native())) continue;
        const int entry = open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
        if (entry < 0) continue;
        struct stat status {};
        if (fstat(entry, &status) == 0 && (status.st_mode & S_IFMT) == kind &&
            status.st_uid == geteuid() && lock_at_once(entry))
            remove(path);
        close(entry);
    }
}

}  // namespace

std::string new_temporary_name(const std::string& folder, const std::string& ending) {
    static std::atomic<unsigned> counter{0};
    std::random_device random;
    return fmt::format("{}{}{}{}-{}-{:08x}{}", folder,
                       folder.empty() || folder.back() == '/' ? "" : "/", file_prefix, getpid(),
                       counter.fetch_add(1), random(), ending);
}

std::string temporary_folder_pattern(const std::string& parent) {
    return (fs::path(parent) / (std::string(folder_prefix) + std::string(random_letters, 'X')))
        .string();
}

bool lock_at_once(int descriptor) noexcept {
    return flock(descriptor, LOCK_EX | LOCK_NB) == 0;
}

void remove_leftover_files(const std::string& folder) {
    if (!is_first_look("file " + folder)) return;
    remove_unused(folder.empty() ? "." : folder, S_IFREG, is_temporary_file,
                  [](const fs::path& path) { unlink(path.c_str()); });
}

void remove_leftover_folders(const std::string& parent) {
    if (!is_first_look("folder " + parent)) return;
    remove_unused(parent, S_IFDIR, is_temporary_folder, [](const fs::path& path) {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    });
}

}  // namespace lancer::io
