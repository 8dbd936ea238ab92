// Work for all cores, handed out in small tasks.
#pragma once

#include <functional>

#include "base/progress.h"

namespace lancer {

/// Gives the next task's number, 0 .. tasks-1, each once; false when none is left.
using NextTask = std::function<bool(int& task)>;

/// Runs `worker` on `threads` threads (0: all cores) with stacks deep enough for the deepest
/// recursion. Calls `progress`, which may be empty, from the calling thread. An exception in a
/// worker is thrown here.
void for_each_task(int tasks, int threads, const Progress& progress,
                   const std::function<void(NextTask)>& worker);

}  // namespace lancer
