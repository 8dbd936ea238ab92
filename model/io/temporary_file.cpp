#include "model/io/temporary_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>

#include "model/diagnostic.h"
#include "model/io/system_error.h"

namespace lancer::io {
namespace {

// What a signal handler may read: no heap, no locks. A name is complete before its slot becomes
// `used`, and the handler looks at nothing else. A name that ends in '/' is a folder's.
enum class State { free, reserved, used };

struct Slot {
    std::atomic<State> state{State::free};
    std::array<char, 4096> name{};
};
static_assert(std::atomic<State>::is_always_lock_free);

std::array<Slot, 32> slots;

/// The slot that now holds `name`, or -1 when all are taken or the name is too long: then the file
/// merely outlives a signal.
int enter(const std::string& name) {
    if (name.size() >= slots[0].name.size()) return -1;
    for (std::size_t i = 0; i < slots.size(); ++i) {
        State expected = State::free;
        if (!slots[i].state.compare_exchange_strong(expected, State::reserved)) continue;
        std::memcpy(slots[i].name.data(), name.c_str(), name.size() + 1);
        slots[i].state.store(State::used);
        return static_cast<int>(i);
    }
    return -1;
}

bool is_folder(const Slot& slot) {
    return slot.name[std::strlen(slot.name.data()) - 1] == '/';
}

void leave(int slot) {
    if (slot >= 0) slots[static_cast<std::size_t>(slot)].state.store(State::free);
}

}  // namespace

TemporaryFile::TemporaryFile(const std::string& folder, const std::string& ending,
                             const std::string& purpose) {
    static std::atomic<unsigned> counter{0};
    std::random_device random;
    for (int attempt = 0;; ++attempt) {
        name_ = fmt::format("{}{}.lancer-{}-{}-{:08x}{}", folder,
                            folder.empty() || folder.back() == '/' ? "" : "/", getpid(),
                            counter.fetch_add(1), random(), ending);
        const int file = open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (file >= 0) {
            close(file);
            slot_ = enter(name_);
            return;
        }
        if (errno != EEXIST || attempt == 100) throw system_error("cannot write", purpose, errno);
    }
}

TemporaryFile::~TemporaryFile() {
    if (!name_.empty()) unlink(name_.c_str());
    leave(slot_);
}

void TemporaryFile::keep_as(const std::string& path) {
    if (std::rename(name_.c_str(), path.c_str()) != 0) {
        throw system_error("cannot write", path, errno);
    }
    name_.clear();
    leave(slot_);
    slot_ = -1;
}

TemporaryFolder::TemporaryFolder() {
    std::error_code error;
    std::string name = (std::filesystem::temp_directory_path(error) / "lancer-XXXXXX").string();
    if (error || mkdtemp(name.data()) == nullptr)
        throw system_error("cannot make", "a temporary folder", error ? error.value() : errno);
    path_ = name;
    slot_ = enter(name + "/");
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
    leave(slot_);
}

void remove_temporary_files() noexcept {
    for (Slot& slot : slots) {
        if (slot.state.load() == State::used && !is_folder(slot)) unlink(slot.name.data());
    }
}

char* next_temporary_folder() noexcept {
    for (Slot& slot : slots) {
        if (slot.state.load() != State::used || !is_folder(slot)) continue;
        slot.state.store(State::reserved);
        return slot.name.data();
    }
    return nullptr;
}

}  // namespace lancer::io
