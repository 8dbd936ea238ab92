// How a long computation reports its progress.
#pragma once

#include <functional>

namespace lancer {

/// Called now and then from the thread that called the computation, with the share done, 0..1.
using Progress = std::function<void(double share)>;

}  // namespace lancer
