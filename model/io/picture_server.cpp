#include "model/io/picture_server.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/signalfd.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include "model/diagnostic.h"
#include "model/io/image_module.h"
#include "model/io/picture_messages.h"
#include "model/io/picture_worker.h"

namespace lancer::io {
namespace {

using Kind = PictureReply::Kind;

PictureReply reply_of(Kind kind, int number, const std::string& text = "") {
    PictureReply reply;
    reply.kind = kind;
    reply.number = number;
    text.copy(reply.text.data(), reply.text.size() - 1);
    return reply;
}

/// The two descriptors of a request; closed by the destructor.
struct Descriptors {
    int input = -1;
    int output = -1;
    Descriptors() = default;
    Descriptors(const Descriptors&) = delete;
    Descriptors& operator=(const Descriptors&) = delete;
    ~Descriptors() {
        for (const int descriptor : {input, output})
            if (descriptor >= 0) close(descriptor);
    }
};

/// Receives a request; false when the socket is closed.
bool receive(int socket, PictureRequest& request, Descriptors& descriptors) {
    iovec part{&request, sizeof request};
    int received[2];
    alignas(cmsghdr) char control[CMSG_SPACE(sizeof received)] = {};
    msghdr message{};
    message.msg_iov = &part;
    message.msg_iovlen = 1;
    message.msg_control = control;
    message.msg_controllen = sizeof control;
    ssize_t count = 0;
    do {
        count = recvmsg(socket, &message, MSG_CMSG_CLOEXEC);
    } while (count < 0 && errno == EINTR);
    const cmsghdr* rights = CMSG_FIRSTHDR(&message);
    if (count != static_cast<ssize_t>(sizeof request) || rights == nullptr ||
        rights->cmsg_type != SCM_RIGHTS || rights->cmsg_len != CMSG_LEN(sizeof received)) {
        return false;
    }
    std::memcpy(received, CMSG_DATA(rights), sizeof received);
    descriptors.input = received[0];
    descriptors.output = received[1];
    return true;
}

/// Reads the end of processes from a descriptor, so that one call can wait for them and the socket.
class EndedProcesses {
  public:
    EndedProcesses() {
        sigset_t children;
        sigemptyset(&children);
        sigaddset(&children, SIGCHLD);
        sigprocmask(SIG_BLOCK, &children, &before_);
        descriptor_ = signalfd(-1, &children, SFD_CLOEXEC | SFD_NONBLOCK);
    }
    ~EndedProcesses() { close(descriptor_); }
    EndedProcesses(const EndedProcesses&) = delete;
    EndedProcesses& operator=(const EndedProcesses&) = delete;
    int descriptor() const { return descriptor_; }
    void forget() const {
        signalfd_siginfo ended;
        while (read(descriptor_, &ended, sizeof ended) > 0) {
        }
    }

  private:
    sigset_t before_{};
    int descriptor_ = -1;
};

/// Waits for `worker`. Kills it when its time is over or when the other end of the socket is
/// closed.
PictureReply wait_for(pid_t worker, std::uint64_t seconds, int socket,
                      const EndedProcesses& ended) {
    using Clock = std::chrono::steady_clock;
    // The system limits its processor time. The wall clock, which runs on even on a busy machine,
    // limits a process that only waits.
    const auto deadline = Clock::now() + std::chrono::seconds(2 * seconds);
    bool killed = false;
    int status = 0;
    while (waitpid(worker, &status, WNOHANG) == 0) {
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
        pollfd watched[2] = {{ended.descriptor(), POLLIN, 0}, {socket, 0, 0}};
        const int wait = static_cast<int>(std::clamp<std::int64_t>(left, 0, 1000));
        poll(watched, killed ? 1 : 2, killed ? -1 : wait);
        ended.forget();
        const bool alone = (watched[1].revents & (POLLHUP | POLLERR)) != 0;
        if (!killed && (alone || left <= 0)) {
            killed = true;
            kill(worker, SIGKILL);
        }
    }
    if (killed) return reply_of(Kind::timed_out, 0);
    if (WIFEXITED(status)) return reply_of(Kind::ended, WEXITSTATUS(status));
    return reply_of(Kind::killed, WTERMSIG(status));
}

PictureReply serve(const PictureRequest& request, const Descriptors& descriptors, int socket) {
    const ImageModule* module = nullptr;
    try {
        module = &image_module();
    } catch (const FileError& error) {
        return reply_of(Kind::not_started, 0, error.what());
    }
    const EndedProcesses ended;
    const pid_t worker = fork();
    if (worker < 0) {
        return reply_of(Kind::not_started, 0,
                        fmt::format("no process can be started: {}", std::strerror(errno)));
    }
    if (worker == 0) {
        for (const int ours : {socket, ended.descriptor()}) close(ours);
        std::_Exit(work_on(request, descriptors.input, descriptors.output, *module));
    }
    return wait_for(worker, request.seconds, socket, ended);
}

}  // namespace

bool serve_pictures(int socket) {
    int type = 0;
    socklen_t length = sizeof type;
    if (getsockopt(socket, SOL_SOCKET, SO_TYPE, &type, &length) != 0 || type != SOCK_SEQPACKET) {
        return false;
    }
    for (;;) {
        PictureRequest request;
        Descriptors descriptors;
        if (!receive(socket, request, descriptors)) return true;
        const PictureReply reply = serve(request, descriptors, socket);
        if (send(socket, &reply, sizeof reply, MSG_NOSIGNAL) < 0) return true;
    }
}

}  // namespace lancer::io
