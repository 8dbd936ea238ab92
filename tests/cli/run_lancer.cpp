#include "tests/cli/run_lancer.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
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

}  // namespace

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
    const fs::path said = fs::path(folder_).parent_path() / "said";
    std::ofstream(said / "in", std::ios::binary) << input;

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addchdir_np(&actions, folder_.c_str());
    posix_spawn_file_actions_addopen(&actions, 0, (said / "in").c_str(), O_RDONLY, 0);
    constexpr int fresh = O_WRONLY | O_CREAT | O_TRUNC;
    posix_spawn_file_actions_addopen(&actions, 1, (said / "out").c_str(), fresh, 0600);
    posix_spawn_file_actions_addopen(&actions, 2, (said / "err").c_str(), fresh, 0600);

    arguments.insert(arguments.begin(), LANCER_PROGRAM);
    std::vector<std::string> environment = variables;
    for (char** variable = environ; *variable != nullptr; ++variable)
        environment.emplace_back(*variable);
    pid_t child = 0;
    const int failed = posix_spawn(&child, LANCER_PROGRAM, &actions, nullptr,
                                   pointers_to(arguments).data(), pointers_to(environment).data());
    posix_spawn_file_actions_destroy(&actions);
    if (failed != 0) throw std::runtime_error("cannot start " LANCER_PROGRAM);

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
