#include "model/io/picture_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <mutex>
#include <system_error>
#include <vector>

#include "model/io/picture_messages.h"

namespace lancer::io {
namespace {

std::string reason(int code) {
    return std::generic_category().message(code);
}

std::vector<char*> pointers(std::vector<std::string>& words) {
    std::vector<char*> out;
    for (std::string& word : words) out.push_back(word.data());
    out.push_back(nullptr);
    return out;
}

/// The environment of this process. Libraries that the picture library loads must not start
/// threads.
std::vector<std::string> variables() {
    std::vector<std::string> out{"OPENBLAS_NUM_THREADS=1", "OMP_NUM_THREADS=1"};
    for (char** entry = environ; *entry != nullptr; ++entry) out.emplace_back(*entry);
    return out;
}

/// Starts `program` as a picture process with `socket` as its standard input and no other open
/// file. Returns an error number.
int spawn(const std::string& program, int socket, pid_t& process) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, socket, STDIN_FILENO);
    // The output of libraries is discarded: their reasons are returned as text.
    for (const int output : {STDOUT_FILENO, STDERR_FILENO})
        posix_spawn_file_actions_addopen(&actions, output, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);

    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t none;
    sigset_t all;
    sigemptyset(&none);
    sigfillset(&all);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setsigdefault(&attributes, &all);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);

    std::vector<std::string> words{"lancer", picture_server_word};
    std::vector<std::string> environment = variables();
    const int failed = posix_spawn(&process, program.c_str(), &actions, &attributes,
                                   pointers(words).data(), pointers(environment).data());
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    return failed;
}

/// The picture process, from the first picture to the end of the program. It ends when the other
/// end of its socket is closed.
class PictureProcess {
  public:
    ~PictureProcess() { stop(); }

    void set_limits(const PictureLimits& limits) {
        const std::lock_guard lock(mutex_);
        limits_ = limits;
    }
    void set_program(const std::filesystem::path& program) {
        const std::lock_guard lock(mutex_);
        stop();
        program_ = program;
    }

    std::string work(PictureTask task, const std::string& format, int input, int output) {
        const std::lock_guard lock(mutex_);
        if (socket_ < 0) {
            std::string problem = start();
            if (!problem.empty()) return problem;
        }
        struct stat status {};
        if (fstat(input, &status) != 0) return reason(errno);
        PictureRequest request;
        request.task = task;
        format.copy(request.format.data(), request.format.size() - 1);
        request.memory = limits_.memory << 20;
        request.seconds = limits_.seconds + (static_cast<std::uint64_t>(status.st_size) >> 20);
        PictureReply reply;
        if (!send(request, input, output) || !receive(reply)) {
            stop();
            return "the process that works on pictures has ended";
        }
        return problem_of(reply, task);
    }

  private:
    std::string start() {
        std::string program = program_.string();
        if (program.empty()) {
            std::error_code error;
            program =
                (std::filesystem::read_symlink("/proc/self/exe", error).parent_path() / "lancer")
                    .string();
        }
        int ends[2];
        if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0) return reason(errno);
        const int failed = spawn(program, ends[1], process_);
        close(ends[1]);
        if (failed == 0) {
            socket_ = ends[0];
            return {};
        }
        close(ends[0]);
        return fmt::format("cannot start '{}', which works on pictures: {}", program,
                           reason(failed));
    }

    void stop() {
        if (socket_ < 0) return;
        close(socket_);
        socket_ = -1;
        while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
        }
    }

    bool send(PictureRequest& request, int input, int output) const {
        iovec part{&request, sizeof request};
        const int descriptors[2] = {input, output};
        alignas(cmsghdr) char control[CMSG_SPACE(sizeof descriptors)] = {};
        msghdr message{};
        message.msg_iov = &part;
        message.msg_iovlen = 1;
        message.msg_control = control;
        message.msg_controllen = sizeof control;
        cmsghdr* rights = CMSG_FIRSTHDR(&message);
        rights->cmsg_level = SOL_SOCKET;
        rights->cmsg_type = SCM_RIGHTS;
        rights->cmsg_len = CMSG_LEN(sizeof descriptors);
        std::memcpy(CMSG_DATA(rights), descriptors, sizeof descriptors);
        ssize_t sent = 0;
        do {
            sent = sendmsg(socket_, &message, MSG_NOSIGNAL);
        } while (sent < 0 && errno == EINTR);
        return sent == static_cast<ssize_t>(sizeof request);
    }

    bool receive(PictureReply& reply) const {
        ssize_t count = 0;
        do {
            count = recv(socket_, &reply, sizeof reply, 0);
        } while (count < 0 && errno == EINTR);
        reply.text.back() = '\0';
        return count == static_cast<ssize_t>(sizeof reply);
    }

    std::string problem_of(const PictureReply& reply, PictureTask task) const {
        using Kind = PictureReply::Kind;
        const std::string too_long = fmt::format(
            "it takes longer than the allowed {} s (--limit-picture-seconds)", limits_.seconds);
        const std::string too_large =
            fmt::format("it needs more memory than the allowed {} MiB (--limit-picture-memory)",
                        limits_.memory);
        if (reply.kind == Kind::not_started) return reply.text.data();
        if (reply.kind == Kind::timed_out) return too_long;
        if (reply.kind == Kind::killed) {
            if (reply.number == SIGXCPU) return too_long;
            if (reply.number == SIGXFSZ) return too_large;
            return fmt::format("the library that {} it crashed ({})",
                               task == PictureTask::read ? "reads" : "writes",
                               sigabbrev(reply.number));
        }
        if (reply.kind == Kind::ended && reply.number == 0) return {};
        if (reply.kind == Kind::ended && reply.number == out_of_memory) return too_large;
        return "the process that works on pictures failed";
    }

    static std::string sigabbrev(int number) {
        const char* name = sigabbrev_np(number);
        return name != nullptr ? fmt::format("SIG{}", name) : fmt::format("signal {}", number);
    }

    std::mutex mutex_;
    PictureLimits limits_;
    std::filesystem::path program_;
    int socket_ = -1;
    pid_t process_ = 0;
};

PictureProcess& picture_process() {
    static PictureProcess process;
    return process;
}

}  // namespace

void set_picture_limits(const PictureLimits& limits) {
    picture_process().set_limits(limits);
}

void set_picture_program(const std::filesystem::path& program) {
    picture_process().set_program(program);
}

std::string work_on_picture(PictureTask task, const std::string& format, int input, int output) {
    return picture_process().work(task, format, input, output);
}

}  // namespace lancer::io
