#include "model/io/part_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "base/sha256.h"
#include "model/io/descriptor.h"
#include "model/io/file.h"
#include "model/io/system_error.h"

namespace lancer::io {
namespace {

/// Fills `bytes` from the offset `at` on; false at the end of the file.
bool read_at(int file, std::string& bytes, std::uint64_t at, const std::string& path) {
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t count =
            pread(file, bytes.data() + done, bytes.size() - done, static_cast<off_t>(at + done));
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) throw system_error("cannot read", path, errno);
        if (count == 0) return false;
        done += static_cast<std::size_t>(count);
    }
    return true;
}

FileError damaged(const std::string& path) {
    return FileError(fmt::format("'{}' is damaged: render this part again", path));
}

}  // namespace

void write_part(const std::string& path, const PartHead& head,
                const std::function<Image(const Strip&)>& draw) {
    write_atomically(path, [&](const std::string& temporary) {
        const Descriptor file(open(temporary.c_str(), O_WRONLY | O_CLOEXEC));
        if (file.number() < 0) throw system_error("cannot write", path, errno);
        std::uint64_t at = file_head(head, std::string(sha256_digits, '0')).size();
        Sha256 digest;
        digest.add(sealed_text(head));
        int index = 0;
        std::string bytes;
        for (const Strip& strip : strips_of(head)) {
            const Image image = draw(strip);
            bytes.clear();
            for (int y = 0; y < strip.rows; ++y) {
                bytes += row_head(head, index, strip.first + y);
                const std::size_t begin = bytes.size();
                encode_row(head, image.pixel(0, y), bytes);
                digest.add(std::string_view(bytes).substr(begin));
            }
            write_all_at(file.number(), bytes, at, path);
            at += bytes.size();
            ++index;
        }
        write_all_at(file.number(), file_head(head, digest.digits()), 0, path);
    });
}

struct PartReader::State {
    explicit State(const std::string& name) : path(name) {
        open_file();
        struct stat status {};
        if (fstat(file->number(), &status) != 0) throw system_error("cannot read", path, errno);
        if (!S_ISREG(status.st_mode))
            throw FileError(fmt::format("'{}' is not a part of a picture: it is not a file", path));
        const auto size = static_cast<std::uint64_t>(status.st_size);
        std::string begin(std::min<std::uint64_t>(size, most_head_text), '\0');
        if (!read_at(file->number(), begin, 0, path)) throw damaged(path);
        const std::optional<ToldHead> told = told_head(begin);
        if (!told) {
            throw FileError(fmt::format(
                "'{}' is damaged, or not a part of a picture: parts are written by render --part",
                path));
        }
        head = told->head;
        seal = told->seal;
        const std::string expected = file_head(head, seal);
        strips = strips_of(head);
        std::uint64_t rows = 0;
        for (const Strip& strip : strips) rows += static_cast<std::uint64_t>(strip.rows);
        row_size = static_cast<std::size_t>(head.width) * pixel_bytes(head);
        const std::uint64_t step = row_head(head, 0, 0).size() + row_size;
        if (size != expected.size() + rows * step) throw damaged(path);
        std::string there(expected.size(), '\0');
        if (!read_at(file->number(), there, 0, path) || there != expected) throw damaged(path);
        file.reset();
        at = expected.size();
        digest.add(sealed_text(head));
    }

    /// If another run writes in between, the digest will differ.
    void open_file() {
        file = std::make_unique<Descriptor>(open(path.c_str(), O_RDONLY | O_CLOEXEC));
        if (file->number() < 0) throw system_error("cannot read", path, errno);
    }

    std::string path;
    std::unique_ptr<Descriptor> file;
    PartHead head;
    std::string seal;
    std::vector<Strip> strips;
    std::size_t row_size = 0;
    std::uint64_t at = 0;   ///< where the next row's head begins
    std::size_t index = 0;  ///< of the strip
    int row = 0;            ///< of that strip
    Sha256 digest;
};

PartReader::PartReader(const std::string& path) : state_(std::make_unique<State>(path)) {}

PartReader::~PartReader() = default;

const PartHead& PartReader::head() const {
    return state_->head;
}

const std::string& PartReader::path() const {
    return state_->path;
}

void PartReader::read_row(double* pixels) {
    State& s = *state_;
    const Strip& strip = s.strips[s.index];
    if (!s.file) s.open_file();
    const std::string expected = row_head(s.head, static_cast<int>(s.index), strip.first + s.row);
    std::string bytes(expected.size() + s.row_size, '\0');
    if (!read_at(s.file->number(), bytes, s.at, s.path) || !bytes.starts_with(expected))
        throw damaged(s.path);
    s.at += bytes.size();
    bytes.erase(0, expected.size());
    s.digest.add(bytes);
    decode_row(s.head, bytes, pixels);
    if (++s.row == strip.rows) {
        s.row = 0;
        ++s.index;
        s.file.reset();
    }
}

void PartReader::finish() {
    if (state_->digest.digits() != state_->seal) throw damaged(state_->path);
}

PartHead checked_part(const std::string& path) {
    PartReader reader(path);
    const PartHead& head = reader.head();
    std::vector<double> row(static_cast<std::size_t>(head.width) *
                            static_cast<std::size_t>(head.channels()));
    for (const Strip& strip : strips_of(head))
        for (int y = 0; y < strip.rows; ++y) reader.read_row(row.data());
    reader.finish();
    return head;
}

}  // namespace lancer::io
