#include "cli/deep_stack.h"

#include <pthread.h>

#include <algorithm>
#include <exception>

#include "model/diagnostic.h"

namespace lancer::cli {
namespace {

struct Task {
    const std::function<void()>& work;
    std::exception_ptr thrown;
};

extern "C" void* run_task(void* argument) {
    auto& task = *static_cast<Task*>(argument);
    try {
        task.work();
    } catch (...) {
        task.thrown = std::current_exception();
    }
    return nullptr;
}

}  // namespace

void run_on_deep_stack(const Limits& limits, const std::function<void()>& work) {
    const Limits defaults;
    if (limits.nesting <= defaults.nesting && limits.calls <= defaults.calls) {
        work();
        return;
    }
    // The default stack serves the default limits, so a multiple serves a multiple. Pages that are
    // never touched cost nothing.
    constexpr std::uint64_t default_stack = 8ull << 20;
    const std::uint64_t factor =
        std::max(limits.nesting / defaults.nesting, limits.calls / defaults.calls) + 1;

    Task task{work, nullptr};
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_t thread{};
    const bool started = pthread_attr_setstacksize(&attributes, factor * default_stack) == 0 &&
                         pthread_create(&thread, &attributes, run_task, &task) == 0;
    pthread_attr_destroy(&attributes);
    if (!started)
        throw FileError("no memory for the recursion that --limit-nesting or --limit-calls allow");
    pthread_join(thread, nullptr);
    if (task.thrown) std::rethrow_exception(task.thrown);
}

}  // namespace lancer::cli
