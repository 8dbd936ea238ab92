// Room for recursion, when --limit-nesting or --limit-calls ask for more of it than a process has.
#pragma once

#include <functional>

#include "parser/parse.h"

namespace lancer::cli {

/// Calls `work`, on a thread with a larger stack where `limits` are above their defaults (which fit
/// into the 8 MiB that a process starts with). What `work` throws arrives here. Throws FileError
/// when there is no room for such a stack.
void run_on_deep_stack(const Limits& limits, const std::function<void()>& work);

}  // namespace lancer::cli
