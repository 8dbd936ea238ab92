#include "tests/cli/run_lancer.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "model/io/image_file.h"

namespace lancer::cli {
namespace {

namespace fs = std::filesystem;

std::string read_text(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<char*> pointers_to(std::vector<std::string>& texts) {
    std::vector<char*> pointers;
    for (std::string& text : texts) pointers.push_back(text.data());
    pointers.push_back(nullptr);
    return pointers;
}

/// Directs standard output. Returns the end of a pipe that must be closed here after the start, or
/// -1.
int direct_output(posix_spawn_file_actions_t& actions, std::optional<BrokenOutput> broken,
                  const std::string& file) {
    if (!broken || *broken == BrokenOutput::full) {
        const int how = broken ? O_WRONLY : O_WRONLY | O_CREAT | O_TRUNC;
        posix_spawn_file_actions_addopen(&actions, 1, broken ? "/dev/full" : file.c_str(), how,
                                         0600);
        return -1;
    }
    if (*broken == BrokenOutput::closed) {
        posix_spawn_file_actions_addclose(&actions, 1);
        return -1;
    }
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    close(ends[0]);
    posix_spawn_file_actions_adddup2(&actions, ends[1], 1);
    return ends[1];
}

/// While it lives this process ignores SIGINT and SIGTERM, and what it starts inherits that.
class IgnoredSignals {
  public:
    explicit IgnoredSignals(bool wanted) : wanted_(wanted) {
        for (std::size_t i = 0; wanted_ && i < numbers.size(); ++i)
            before_[i] = signal(numbers[i], SIG_IGN);
    }
    ~IgnoredSignals() {
        for (std::size_t i = 0; wanted_ && i < numbers.size(); ++i) signal(numbers[i], before_[i]);
    }
    IgnoredSignals(const IgnoredSignals&) = delete;
    IgnoredSignals& operator=(const IgnoredSignals&) = delete;

  private:
    static constexpr std::array<int, 2> numbers{SIGINT, SIGTERM};
    bool wanted_;
    std::array<sighandler_t, 2> before_{};
};

}  // namespace

const char* lancer_program() {
    return LANCER_PROGRAM;
}

Workplace::Workplace() {
    std::string name = (fs::temp_directory_path() / "lancer-test-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    folder_ = name;
    fs::create_directory(folder_ + "/work");
    fs::create_directory(folder_ + "/said");
    folder_ += "/work";
}

Workplace::~Workplace() {
    std::error_code ignored;
    fs::permissions(folder_, fs::perms::owner_all, ignored);
    fs::remove_all(fs::path(folder_).parent_path(), ignored);
}

Finished Workplace::run(std::vector<std::string> arguments, const std::string& input,
                        const std::vector<std::string>& variables) const {
    return run_in({.input = input, .variables = variables}, std::move(arguments));
}

Finished Workplace::run_in(const Surroundings& surroundings,
                           std::vector<std::string> arguments) const {
    return finish(start(surroundings, std::move(arguments)));
}

pid_t Workplace::start(const Surroundings& surroundings, std::vector<std::string> arguments) const {
    const fs::path said = fs::path(folder_).parent_path() / "said";
    std::ofstream(said / "in", std::ios::binary) << surroundings.input;
    std::ofstream(said / "out", std::ios::trunc).close();

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addchdir_np(&actions, folder_.c_str());
    posix_spawn_file_actions_addopen(&actions, 0, (said / "in").c_str(), O_RDONLY, 0);
    constexpr int fresh = O_WRONLY | O_CREAT | O_TRUNC;
    const int pipe_end = direct_output(actions, surroundings.output, (said / "out").string());
    posix_spawn_file_actions_addopen(&actions, 2, (said / "err").c_str(), fresh, 0600);

    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    // This process may ignore SIGPIPE; the program starts with the defaults, as from a shell.
    sigset_t usual;
    sigemptyset(&usual);
    for (const int number : {SIGPIPE, SIGXFSZ}) sigaddset(&usual, number);
    if (!surroundings.ignores_signals)
        for (const int number : {SIGINT, SIGTERM}) sigaddset(&usual, number);
    posix_spawnattr_setsigdefault(&attributes, &usual);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
    const IgnoredSignals ignored(surroundings.ignores_signals);

    arguments.insert(arguments.begin(), LANCER_PROGRAM);
    std::string program = LANCER_PROGRAM;
    if (!surroundings.limits.empty()) {
        program = "/bin/bash";
        const std::string script = "ulimit " + surroundings.limits + " && exec \"$0\" \"$@\"";
        arguments.insert(arguments.begin(), {program, "-c", script});
    }
    std::vector<std::string> environment = surroundings.variables;
    for (char** variable = environ; *variable != nullptr; ++variable)
        environment.emplace_back(*variable);
    pid_t child = 0;
    const int failed = posix_spawn(&child, program.c_str(), &actions, &attributes,
                                   pointers_to(arguments).data(), pointers_to(environment).data());
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    if (pipe_end >= 0) close(pipe_end);
    if (failed != 0) throw std::runtime_error("cannot start " + program);
    return child;
}

Finished Workplace::finish(pid_t child) const {
    const fs::path said = fs::path(folder_).parent_path() / "said";
    int status = 0;
    waitpid(child, &status, 0);
    Finished finished;
    finished.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    finished.out = read_text(said / "out");
    finished.err = read_text(said / "err");
    return finished;
}

void Workplace::write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
}

std::string Workplace::read(const std::string& name) const {
    return read_text(path(name));
}

bool Workplace::exists(const std::string& name) const {
    return fs::exists(path(name));
}

std::vector<std::string> Workplace::files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_))
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

Image Workplace::image(const std::string& name) const {
    return io::read_image(path(name));
}

std::string small_scene() {
    return R"(
param size = 0.8
image { width 64 height 48 }
camera front { position [3, 3, 5] look_at [0, 0.5, 0] }
camera above { position [0, 6, 0.1] look_at [0, 0, 0] }
light point { position [4, 6, 3] }
background [0.2, 0.3, 0.5]
plane { normal [0, 1, 0] material { color [0.8, 0.8, 0.7] } }
sphere { center [frame * 0.1, size, 0] radius size material { color [0.9, 0.3, 0.2] phong 0.4 } }
box { min [1, 0, -1] max [1.5, 1, 0.5] material { color [0.2, 0.5, 0.9] reflection 0.2 } }
)";
}

}  // namespace lancer::cli
