#include "base/parallel.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "base/deep_thread.h"

namespace lancer {
namespace {

/// 1,000 levels of recursion at up to 60 kB each (with sanitizers). Pages that nobody touches cost
/// nothing.
constexpr std::size_t stack_bytes = std::size_t(128) << 20;

}  // namespace

void for_each_task(int tasks, int threads, const Progress& progress,
                   const std::function<void(NextTask)>& worker) {
    if (threads <= 0) threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    threads = std::min(threads, std::max(tasks, 1));
    std::atomic<int> next{0};
    std::atomic<int> done{0};
    std::mutex mutex;
    std::condition_variable changed;
    int running = threads;
    std::exception_ptr failure;

    const auto body = [&] {
        try {
            bool first = true;
            worker([&](int& task) {
                if (!first) done.fetch_add(1, std::memory_order_relaxed);
                first = false;
                task = next.fetch_add(1, std::memory_order_relaxed);
                return task < tasks;
            });
        } catch (...) {
            next = tasks;
            const std::lock_guard lock(mutex);
            if (!failure) failure = std::current_exception();
        }
        const std::lock_guard lock(mutex);
        --running;
        changed.notify_one();
    };
    {
        std::vector<std::unique_ptr<DeepThread>> pool;
        pool.reserve(static_cast<std::size_t>(std::max(threads, 0)));
        try {
            for (int i = 0; i < threads; ++i)
                pool.push_back(std::make_unique<DeepThread>(stack_bytes, body));
        } catch (...) {
            next = tasks;  // running tasks finish; no new task starts
            throw;
        }
        std::unique_lock lock(mutex);
        while (running > 0) {
            changed.wait_for(lock, std::chrono::milliseconds(100));
            if (progress && running > 0) {
                lock.unlock();
                progress(tasks == 0 ? 1.0 : static_cast<double>(done.load()) / tasks);
                lock.lock();
            }
        }
    }
    if (failure) std::rethrow_exception(failure);
    if (progress) progress(1.0);
}

}  // namespace lancer
