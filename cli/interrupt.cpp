#include "cli/interrupt.h"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <ctime>
#include <initializer_list>

#include "model/io/temporary_registry.h"

namespace lancer::cli {
namespace {

constexpr int exit_code_of_signals = 128;  // plus the signal's number, as in shells

/// Starts a process that waits until this one has ended, and POV-Ray with it, and then removes the
/// folder. After a fork in a signal handler only async-signal-safe calls are allowed, so `rm` does
/// the removing.
void sweep_after_the_end(char* folder) {
    const pid_t parent = getpid();
    if (fork() != 0) return;
    const timespec moment{0, 20'000'000};
    while (getppid() == parent) nanosleep(&moment, nullptr);
    nanosleep(&moment, nullptr);
    std::array<char, 3> program{"rm"};
    std::array<char, 4> how{"-rf"};
    const std::array<char*, 4> command{program.data(), how.data(), folder, nullptr};
    execv("/bin/rm", command.data());
    _exit(1);
}

extern "C" void end_process(int signal_number) {
    // Only async-signal-safe calls. The line feed ends a line that may hold a progress bar.
    io::remove_temporary_files();
    if (isatty(STDERR_FILENO) == 1) [[maybe_unused]]
        const auto written = write(STDERR_FILENO, "\n", 1);
    io::remove_temporary_files();
    while (char* folder = io::next_temporary_folder()) sweep_after_the_end(folder);
    _exit(exit_code_of_signals + signal_number);
}

}  // namespace

void end_on_interrupt() {
    struct sigaction action {};
    action.sa_handler = end_process;
    for (const int signal_number : {SIGINT, SIGTERM}) {
        struct sigaction before {};
        sigaction(signal_number, nullptr, &before);
        // If the caller ignores the signal (nohup, a shell's background job), it stays ignored.
        if (before.sa_handler != SIG_IGN) sigaction(signal_number, &action, nullptr);
    }
}

void keep_on_broken_output() {
    for (const int signal_number : {SIGPIPE, SIGXFSZ}) signal(signal_number, SIG_IGN);
}

void open_missing_streams() {
    // open() takes the lowest free number, so each stream is opened before the next is checked. The
    // modes are reversed on purpose: reading from 0 and writing to 1 and 2 must fail. /dev/full
    // also makes a write through the name /dev/stdout fail.
    if (fcntl(STDIN_FILENO, F_GETFD) < 0) [[maybe_unused]]
        const int input = open("/dev/null", O_WRONLY);
    for (const int number : {STDOUT_FILENO, STDERR_FILENO}) {
        if (fcntl(number, F_GETFD) < 0 && open("/dev/full", O_RDONLY) < 0) [[maybe_unused]]
            const int output = open("/dev/null", O_RDONLY);
    }
}

}  // namespace lancer::cli
