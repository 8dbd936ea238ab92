#include "model/io/temporary_registry.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <cstring>

namespace lancer::io {
namespace {

// Data that a signal handler may read: no heap, no locks. A name is complete before its slot
// becomes `used`, and the handler reads only such slots.
enum class State { free, reserved, used };

struct Slot {
    std::atomic<State> state{State::free};
    std::array<char, 4096> name{};
};
static_assert(std::atomic<State>::is_always_lock_free);

std::array<Slot, 32> slots;

bool is_folder(const Slot& slot) {
    return slot.name[std::strlen(slot.name.data()) - 1] == '/';
}

}  // namespace

int remember_temporary(const std::string& name) {
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

void forget_temporary(int slot) {
    if (slot >= 0) slots[static_cast<std::size_t>(slot)].state.store(State::free);
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
