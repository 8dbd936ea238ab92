#include "cli/deep_stack.h"

#include <algorithm>
#include <system_error>

#include "base/deep_thread.h"
#include "model/diagnostic.h"

namespace lancer::cli {

void run_on_deep_stack(const Limits& limits, const std::function<void()>& work) {
    const Limits defaults;
    if (limits.nesting <= defaults.nesting && limits.calls <= defaults.calls) {
        work();
        return;
    }
    // The default stack is enough for the default limits, so a multiple is enough for a multiple.
    constexpr std::uint64_t default_stack = 8ull << 20;
    const std::uint64_t factor =
        std::max(limits.nesting / defaults.nesting, limits.calls / defaults.calls) + 1;
    try {
        lancer::run_on_deep_stack(factor * default_stack, work);
    } catch (const std::system_error&) {
        throw FileError(
            "not enough memory for the recursion that --limit-nesting or --limit-calls allow");
    }
}

}  // namespace lancer::cli
