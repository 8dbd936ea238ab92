#include "model/io/picture_input.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

#include "model/io/file.h"
#include "model/io/system_error.h"

namespace lancer::io {

PictureInput::PictureInput(const std::string& path) : path_(path) {
    if (path == "-" || is_stream(path)) {
        bytes_ = read_file(path);
        return;
    }
    file_ = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file_ < 0) throw system_error("cannot read", path, errno);
    start_.resize(16);
    const ssize_t count = pread(file_, start_.data(), start_.size(), 0);
    if (count < 0) {
        const int code = errno;
        close(file_);
        throw system_error("cannot read", path, code);
    }
    start_.resize(static_cast<std::size_t>(count));
}

PictureInput::~PictureInput() {
    if (file_ >= 0) close(file_);
}

std::string PictureInput::bytes() const {
    return file_ < 0 ? bytes_ : read_file(path_);
}

int PictureInput::descriptor() {
    if (file_ >= 0) return file_;
    if (!memory_) {
        memory_.emplace();
        write_at(memory_->descriptor(), bytes_.data(), bytes_.size(), 0);
    }
    return memory_->descriptor();
}

}  // namespace lancer::io
