// A larger stack for the recursion that --limit-nesting or --limit-calls allow.
#pragma once

#include <functional>

#include "parser/parse.h"

namespace lancer::cli {

/// Calls `work`. Where `limits` are above their defaults (which fit into the 8 MiB that a process
/// starts with), it runs on a thread with a larger stack. Passes on what `work` throws. Throws
/// FileError when there is no memory for such a stack.
void run_on_deep_stack(const Limits& limits, const std::function<void()>& work);

}  // namespace lancer::cli
