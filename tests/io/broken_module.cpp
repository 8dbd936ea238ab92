// A module that misbehaves like a library with a damaged picture. The "picture" is a word that
// selects the misbehaviour.
#include <arpa/inet.h>
#include <fcntl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <ctime>
#include <stdexcept>
#include <thread>
#include <vector>

#include "model/io/image_module.h"
#include "model/io/module/confine.h"

namespace lancer::io {
namespace {

std::string allowed_if(bool possible) {
    return possible ? "allowed" : "forbidden";
}

bool can_start_a_process() {
    const pid_t child = fork();
    if (child == 0) std::_Exit(0);
    if (child > 0) waitpid(child, nullptr, 0);
    return child > 0;
}

std::string misbehave(std::string_view bytes, PictureSink& sink) {
    const std::string_view what = bytes.substr(bytes.find('\n') + 1);
    StoredShape shape;
    shape.width = shape.height = 2;
    shape.channels = 1;
    if (what == "abort") std::abort();
    if (what == "segv") std::raise(SIGSEGV);
    if (what == "fpe") std::raise(SIGFPE);
    if (what == "exit") std::_Exit(0);
    if (what == "exit 3") std::_Exit(3);
    if (what == "throw") throw std::runtime_error("thrown");
    if (what == "spin") {
        volatile bool on = true;
        while (on) {
        }
    }
    if (what == "sleep") {
        const timespec hour{3600, 0};
        nanosleep(&hour, nullptr);
    }
    if (what == "memory") {
        std::vector<std::vector<char>> all;
        for (;;) all.emplace_back(1 << 20, 'x');
    }
    if (what == "pixels") {
        shape.width = shape.height = 8192;
        sink.shape(shape);
        const std::vector<char> row(8192);
        for (int y = 0; y < 8192; ++y) sink.bytes(row.data(), row.size());
        return "";
    }
    if (what == "thread") {
        bool ran = false;
        std::thread([&ran] { ran = true; }).join();
        return allowed_if(ran);
    }
    if (what == "open") return allowed_if(open("/etc/passwd", O_RDONLY | O_CLOEXEC) >= 0);
    if (what == "create")
        return allowed_if(open("made", O_WRONLY | O_CREAT | O_CLOEXEC, 0600) >= 0);
    if (what == "unlink") return allowed_if(unlink("kept") == 0);
    if (what == "socket") return allowed_if(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0) >= 0);
    if (what == "fork") return allowed_if(can_start_a_process());
    if (what == "kill") return allowed_if(kill(getppid(), 0) == 0);
    if (what == "descriptors") {
        int open_ones = 0;
        for (int i = 3; i < 1024; ++i) open_ones += lseek(i, 0, SEEK_CUR) >= 0 ? 1 : 0;
        return std::to_string(open_ones);
    }
    if (what == "few") {  // fewer pixels than announced
        sink.shape(shape);
        sink.bytes("abc", 3);
        return "";
    }
    if (what == "nothing") return "";
    sink.shape(shape);
    sink.bytes("\x00\x33\x66\xFF", 4);
    return "";
}

std::string read(std::string_view bytes, const std::string&, PictureSink& sink) {
    return misbehave(bytes, sink);
}

std::string write(const StoredShape&, const void*, const std::string&, PictureSink&) {
    std::abort();
}

std::string write_rows(const StoredShape&, const RowsOf&, const std::string&, int) {
    std::abort();
}

const ImageModule functions{read, write, write_rows, confine};

}  // namespace
}  // namespace lancer::io

const lancer::io::ImageModule* lancer_image_module() {
    return &lancer::io::functions;
}
