// A thread with a stack as deep as its recursion needs, which std::thread does not offer.
#pragma once

#include <pthread.h>

#include <cstddef>
#include <functional>

namespace lancer {

/// Runs while the object lives: the destructor waits for its end.
class DeepThread {
  public:
    /// `body` must not throw. Throws std::system_error when the system has no thread to give, or no
    /// memory for the stack. Pages of the stack that nobody touches cost nothing.
    DeepThread(std::size_t stack_bytes, std::function<void()> body);
    ~DeepThread();
    DeepThread(const DeepThread&) = delete;
    DeepThread& operator=(const DeepThread&) = delete;

  private:
    static void* enter(void* self);

    std::function<void()> body_;
    pthread_t thread_{};
};

/// Calls `work` on such a thread and waits for it. What it throws arrives here.
void run_on_deep_stack(std::size_t stack_bytes, const std::function<void()>& work);

}  // namespace lancer
