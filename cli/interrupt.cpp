#include "cli/interrupt.h"

#include <signal.h>
#include <unistd.h>

#include <array>
#include <ctime>
#include <initializer_list>

#include "model/io/temporary_file.h"

namespace lancer::cli {
namespace {

constexpr int exit_code_of_signals = 128;  // plus the signal's number, as shells have it

/// A process of its own that waits for the end of this one, and of POV-Ray, which dies with it, and
/// then removes the folder. After a fork in a signal handler only calls that are safe there are
/// left, so that removing is the business of `rm`.
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
    // Only what is safe in a signal handler. A progress bar may stand on the line.
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
        // A caller that ignores the signal (nohup, a shell's background job) has its reasons.
        if (before.sa_handler != SIG_IGN) sigaction(signal_number, &action, nullptr);
    }
}

}  // namespace lancer::cli
