#include "model/io/picture_worker.h"

#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <exception>
#include <fstream>
#include <limits>
#include <new>
#include <string>
#include <string_view>

#include "base/sanitized.h"
#include "model/io/image_checks.h"
#include "model/io/stored_image.h"

namespace lancer::io {
namespace {

/// At `value` the system sends a signal, at `value` + `grace` it kills the process.
void limit(__rlimit_resource resource, std::uint64_t value, std::uint64_t grace = 0) {
    rlimit bounds{};
    getrlimit(resource, &bounds);
    bounds.rlim_max = std::min<rlim_t>(bounds.rlim_max, value + grace);
    bounds.rlim_cur = std::min<rlim_t>(bounds.rlim_cur, value);
    setrlimit(resource, &bounds);
}

/// The bytes of private memory that this process already has.
[[maybe_unused]] std::uint64_t data_bytes() {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
        std::uint64_t kibibytes = 0;
        if (word == "VmData:" && status >> kibibytes) return kibibytes << 10;
    }
    return 0;
}

void limit_resources(const PictureRequest& request) {
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_CPU, request.seconds, 1);
    limit(RLIMIT_FSIZE, request.memory);
#ifndef LANCER_SANITIZED
    limit(RLIMIT_DATA, data_bytes() + request.memory);
#endif
    // A crash must not leave a core dump for a debugger, and no handler of a library may hide it.
    for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU, SIGXFSZ, SIGCHLD})
        std::signal(number, SIG_DFL);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
}

/// The content of a file or of shared memory.
std::string_view mapped(int file) {
    struct stat status {};
    if (fstat(file, &status) != 0 || status.st_size == 0) return {};
    const auto size = static_cast<std::size_t>(status.st_size);
    void* memory = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0);
    if (memory == MAP_FAILED) throw std::bad_alloc();
    return {static_cast<const char*>(memory), size};
}

std::string read_picture(std::string_view bytes, const std::string& format,
                         const ImageModule& module, PictureSink& sink) {
    std::string problem = format == "jpeg"      ? jpeg_problem(bytes)
                          : format == "openexr" ? exr_problem(bytes)
                                                : std::string();
    return problem.empty() ? module.read(bytes, format, sink) : problem;
}

std::string write_picture(int input, std::string_view bytes, const std::string& format,
                          const ImageModule& module, PictureSink& sink) {
    const SharedResult picture = read_shared(input);
    if (!picture.problem.empty()) return picture.problem;
    return module.write(picture.shape, bytes.data() + picture.first, format, sink);
}

}  // namespace

int work_on(const PictureRequest& request, int input, int output, const ImageModule& module) {
    try {
        limit_resources(request);
        module.confine();
        const std::string format = request.format.data();
        const std::string_view bytes = mapped(input);
        SharedSink sink(output);
        sink.finish(request.task == PictureTask::read
                        ? read_picture(bytes, format, module, sink)
                        : write_picture(input, bytes, format, module, sink));
        return 0;
    } catch (const std::bad_alloc&) {
        return out_of_memory;
    } catch (const std::exception&) {
        return 1;
    }
}

}  // namespace lancer::io
