// Ctrl-C: ends the process at once, except while a file is being written.
#pragma once

namespace lancer::cli {

/// From now on SIGINT and SIGTERM end the process with exit code 130 (143), leaving no half file.
void end_on_interrupt();

/// While it lives, an interrupt waits: a temporary file is finished and renamed, or removed.
class HoldInterrupts {
  public:
    HoldInterrupts();
    ~HoldInterrupts();
    HoldInterrupts(const HoldInterrupts&) = delete;
    HoldInterrupts& operator=(const HoldInterrupts&) = delete;
};

}  // namespace lancer::cli
