#include "cli/interrupt.h"

#include <signal.h>
#include <unistd.h>

#include <initializer_list>

#include "model/io/temporary_file.h"

namespace lancer::cli {
namespace {

constexpr int exit_code_of_signals = 128;  // plus the signal's number, as shells have it

extern "C" void end_process(int signal_number) {
    // Only what is safe in a signal handler. A progress bar may stand on the line.
    io::remove_temporary_files();
    if (isatty(STDERR_FILENO) == 1) [[maybe_unused]]
        const auto written = write(STDERR_FILENO, "\n", 1);
    io::remove_temporary_files();
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
