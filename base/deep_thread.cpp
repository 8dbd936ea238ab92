#include "base/deep_thread.h"

#include <exception>
#include <system_error>
#include <utility>

namespace lancer {

DeepThread::DeepThread(std::size_t stack_bytes, std::function<void()> body)
    : body_(std::move(body)) {
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    int failed = pthread_attr_setstacksize(&attributes, stack_bytes);
    if (failed == 0) failed = pthread_create(&thread_, &attributes, &DeepThread::enter, this);
    pthread_attr_destroy(&attributes);
    if (failed != 0)
        throw std::system_error(failed, std::generic_category(), "cannot start a thread");
}

DeepThread::~DeepThread() {
    pthread_join(thread_, nullptr);
}

void* DeepThread::enter(void* self) {
    static_cast<DeepThread*>(self)->body_();
    return nullptr;
}

void run_on_deep_stack(std::size_t stack_bytes, const std::function<void()>& work) {
    std::exception_ptr thrown;
    {
        const DeepThread thread(stack_bytes, [&] {
            try {
                work();
            } catch (...) {
                thrown = std::current_exception();
            }
        });
    }
    if (thrown) std::rethrow_exception(thrown);
}

}  // namespace lancer
