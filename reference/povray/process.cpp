#include "reference/povray/process.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <system_error>
#include <thread>

#include "model/diagnostic.h"

extern char** environ;

namespace lancer::reference {

namespace {

using Clock = std::chrono::steady_clock;

[[noreturn]] void fail(const std::string& what) {
    throw FileError(what + ": " + std::generic_category().message(errno));
}

struct Descriptor {
    int fd = -1;
    ~Descriptor() {
        if (fd >= 0) ::close(fd);
    }
};

std::vector<std::string> environment_with_home(const std::string& home) {
    std::vector<std::string> out;
    for (char** entry = environ; *entry; ++entry)
        if (std::strncmp(*entry, "HOME=", 5) != 0) out.emplace_back(*entry);
    out.push_back("HOME=" + home);
    return out;
}

std::vector<char*> pointers(std::vector<std::string>& words) {
    std::vector<char*> out;
    out.reserve(words.size() + 1);
    for (std::string& word : words) out.push_back(word.data());
    out.push_back(nullptr);
    return out;
}

/// Runs between fork and exec, so it may call only functions that are safe after a fork of a
/// program with threads.
[[noreturn]] void become(char* const* command, char* const* environment, const char* folder,
                         int messages, int nothing, pid_t parent) {
    ::setpgid(0, 0);
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    sigset_t none;
    ::sigemptyset(&none);
    ::sigprocmask(SIG_SETMASK, &none, nullptr);
    for (const int ignored_here : {SIGPIPE, SIGXFSZ}) ::signal(ignored_here, SIG_DFL);
    const bool ready = ::getppid() == parent && ::chdir(folder) == 0 && ::dup2(nothing, 0) >= 0 &&
                       ::dup2(messages, 1) >= 0 && ::dup2(messages, 2) >= 0;
    if (ready) ::execve(command[0], command, environment);
    std::_Exit(127);
}

/// Waits for the process, or kills its process group when the time is over.
int wait_for(pid_t pid, Clock::time_point deadline, bool& timed_out) {
    int status = 0;
    for (auto pause = std::chrono::milliseconds(1);;) {
        const pid_t ended = ::waitpid(pid, &status, timed_out ? 0 : WNOHANG);
        if (ended == pid) break;
        if (ended < 0 && errno != EINTR) fail("cannot wait for a process");
        if (Clock::now() >= deadline && !timed_out) {
            timed_out = true;
            ::kill(-pid, SIGKILL);
            continue;
        }
        std::this_thread::sleep_for(pause);
        if (pause.count() < 8) pause *= 2;
    }
    ::kill(-pid, SIGKILL);  // ends what it left running; ESRCH is the usual result
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

std::string read_start(int fd) {
    std::string out(std::size_t(1) << 20, '\0');
    const ssize_t count = ::pread(fd, out.data(), out.size(), 0);
    out.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    return out;
}

}  // namespace

ProcessResult run_process(const std::vector<std::string>& command,
                          const std::filesystem::path& folder, double time_limit_seconds) {
    std::vector<std::string> words = command;
    std::vector<std::string> variables = environment_with_home(folder.string());
    const std::vector<char*> argv = pointers(words);
    const std::vector<char*> envp = pointers(variables);
    const Descriptor messages{
        ::open((folder / "messages").c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0600)};
    const Descriptor nothing{::open("/dev/null", O_RDONLY | O_CLOEXEC)};
    if (messages.fd < 0 || nothing.fd < 0) fail("cannot start '" + command[0] + "'");

    const auto start = Clock::now();
    const pid_t parent = ::getpid();
    const pid_t pid = ::fork();
    if (pid < 0) fail("cannot start '" + command[0] + "'");
    if (pid == 0) become(argv.data(), envp.data(), folder.c_str(), messages.fd, nothing.fd, parent);
    ::setpgid(pid, pid);  // called in both processes, since either may run first

    ProcessResult result;
    const auto limit = std::chrono::duration_cast<Clock::duration>(
        std::chrono::duration<double>(time_limit_seconds));
    result.exit_code = wait_for(pid, start + limit, result.timed_out);
    result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    result.messages = read_start(messages.fd);
    return result;
}

}  // namespace lancer::reference
