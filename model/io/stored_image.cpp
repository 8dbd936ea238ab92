#include "model/io/stored_image.h"

#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>
#include <type_traits>

#include "model/io/image_limits.h"
#include "model/io/quantize.h"
#include "model/io/system_error.h"

namespace lancer::io {
namespace {

constexpr std::uint32_t mark = 0x4C504943;
constexpr std::uint64_t longest_text = 1 << 16;

enum class Content : std::uint32_t { picture = 1, file, problem };

/// At the start of the memory. The text follows (the problem; or the names of the extra channels
/// and the names and values of notes, each ended by a zero), then the pixels or bytes.
struct Header {
    std::uint32_t mark;
    Content content;
    std::uint32_t width, height, channels;
    SampleType type;
    std::uint32_t premultiplied, orientation, extra_channels, notes;
    std::uint32_t text_size, unused;
    std::uint64_t size;
};

/// The offset of the pixels or bytes, aligned for every sample type.
std::uint64_t begin_after(std::uint64_t text_size) {
    return (sizeof(Header) + text_size + 7) / 8 * 8;
}

void read_at(int memory, void* data, std::size_t size, std::uint64_t at) {
    auto* to = static_cast<char*>(data);
    while (size > 0) {
        const ssize_t count = pread(memory, to, size, static_cast<off_t>(at));
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) throw system_error("cannot read", "shared memory", count < 0 ? errno : EIO);
        to += count;
        at += static_cast<std::uint64_t>(count);
        size -= static_cast<std::size_t>(count);
    }
}

std::string joined(const StoredShape& shape) {
    std::string text;
    const auto add = [&](const std::string& word) { text.append(word.c_str()).push_back('\0'); };
    for (const std::string& name : shape.extra_names) add(name);
    for (const auto& [name, value] : shape.notes) {
        add(name);
        add(value);
    }
    return text;
}

/// Copies the words in `text` to the shape; false when their number is wrong.
bool split(const std::string& text, const Header& header, StoredShape& shape) {
    std::vector<std::string> words;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = text.find('\0', at);
        if (end == std::string::npos) return false;
        words.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    if (words.size() != header.extra_channels + std::uint64_t{2} * header.notes) return false;
    const auto notes = words.begin() + static_cast<std::ptrdiff_t>(header.extra_channels);
    for (auto word = notes; word != words.end(); word += 2)
        shape.notes.emplace_back(word[0], word[1]);
    shape.extra_names.assign(words.begin(), notes);
    return true;
}

/// A library's message, on one line and safe for a terminal.
std::string printable(std::string text) {
    while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
    for (char& c : text) {
        if (static_cast<unsigned char>(c) < ' ' || c == '\x7F') c = ' ';
    }
    return text.empty() ? "the library that reads it gives no reason" : text;
}

bool is_valid(const Header& header, std::uint64_t size) {
    if (header.mark != mark || header.text_size > longest_text) return false;
    if (header.content == Content::problem) return size >= sizeof header + header.text_size;
    const std::uint64_t first = begin_after(header.text_size);
    if (size < first || header.size != size - first) return false;
    if (header.content == Content::file) return true;
    if (header.content != Content::picture || header.type < SampleType::uint8 ||
        header.type > SampleType::float64 || header.orientation < 1 || header.orientation > 8 ||
        header.channels > most_channels || header.extra_channels >= header.channels) {
        return false;
    }
    if (!size_problem(header.width, header.height, static_cast<int>(header.channels)).empty()) {
        return false;
    }
    const std::uint32_t color = header.channels - header.extra_channels;
    if (color != 1 && color != 3 && color != 4) return false;
    return header.size ==
           std::uint64_t{header.width} * header.height * header.channels * bytes_of(header.type);
}

/// The place of a stored row in the picture: the first pixel, and the distance to the next.
struct Place {
    std::ptrdiff_t first;
    std::ptrdiff_t step;
};

/// Turns the picture upright. EXIF 2.32, 4.6.4: from 5 on, rows become columns.
class Upright {
  public:
    explicit Upright(const StoredShape& shape)
        : turned_(shape.orientation >= 5),
          width_(turned_ ? shape.height : shape.width),
          height_(turned_ ? shape.width : shape.height) {
        // Whether the first row and the first column of the stored picture are the last ones.
        const int o = shape.orientation;
        rows_backwards_ = o == 3 || o == 4 || o == 6 || o == 7;
        columns_backwards_ = o == 2 || o == 3 || o == 7 || o == 8;
    }
    int width() const { return width_; }
    int height() const { return height_; }

    /// In pixels.
    Place row(int y) const {
        const int rows = turned_ ? width_ : height_;
        const int columns = turned_ ? height_ : width_;
        const std::ptrdiff_t row_step = turned_ ? 1 : width_;
        const std::ptrdiff_t column_step = turned_ ? width_ : 1;
        const int row = rows_backwards_ ? rows - 1 - y : y;
        const int column = columns_backwards_ ? columns - 1 : 0;
        return {row * row_step + column * column_step,
                columns_backwards_ ? -column_step : column_step};
    }

  private:
    bool turned_;
    int width_;
    int height_;
    bool rows_backwards_;
    bool columns_backwards_;
};

/// Decodes integers to light; for alpha and extra channels, to a fraction.
template <class Value>
class Decoder {
  public:
    Decoder(const StoredShape& shape, ColorSpace space)
        : color_(std::min(3, shape.channels - static_cast<int>(shape.extra_names.size()))),
          light_(space == ColorSpace::linear ? decoding_table(top, [](double v) { return v; })
                                             : decoding_table(top, srgb_decode)) {}
    double operator()(int channel, Value value) const {
        return channel < color_ ? light_[value] : static_cast<double>(value) / top;
    }

  private:
    static constexpr int top = std::numeric_limits<Value>::max();
    int color_;
    std::vector<double> light_;
};

/// Floats are copied.
template <class Value>
requires std::is_floating_point_v<Value>
class Decoder<Value> {
  public:
    Decoder(const StoredShape&, ColorSpace) {}
    double operator()(int, Value value) const { return static_cast<double>(value); }
};

template <class Value>
Image decoded(int memory, const SharedResult& result, ColorSpace space) {
    const StoredShape& shape = result.shape;
    const Upright upright(shape);
    Image image(upright.width(), upright.height(), shape.channels);
    image.extra_names = shape.extra_names;
    const bool divide = shape.premultiplied && image.color_channels() == 4;
    const Decoder<Value> decode(shape, space);
    const int channels = shape.channels;
    const std::size_t row_values = static_cast<std::size_t>(shape.width) * std::size_t(channels);
    const int step = static_cast<int>(std::max<std::size_t>(1, (1 << 20) / shape.row_bytes()));
    std::vector<Value> rows(row_values * static_cast<std::size_t>(std::min(step, shape.height)));
    for (int y = 0; y < shape.height; ++y) {
        if (y % step == 0) {
            const int count = std::min(step, shape.height - y);
            read_at(memory, rows.data(), shape.row_bytes() * static_cast<std::size_t>(count),
                    result.first + shape.row_bytes() * static_cast<std::size_t>(y));
        }
        const Value* in = rows.data() + row_values * static_cast<std::size_t>(y % step);
        const Place place = upright.row(y);
        for (int x = 0; x < shape.width; ++x) {
            double* out = image.data.data() + (place.first + place.step * x) * channels;
            for (int c = 0; c < channels; ++c) out[c] = decode(c, in[c]);
            for (int c = 0; divide && c < 3 && out[3] != 0; ++c) out[c] /= out[3];
            in += channels;
        }
    }
    return image;
}

}  // namespace

SharedMemory::SharedMemory() : descriptor_(memfd_create("lancer picture", MFD_CLOEXEC)) {
    if (descriptor_ < 0) throw system_error("cannot make", "shared memory", errno);
}

SharedMemory::~SharedMemory() {
    close(descriptor_);
}

void write_at(int memory, const void* data, std::size_t size, std::uint64_t at) {
    const auto* from = static_cast<const char*>(data);
    while (size > 0) {
        const ssize_t count = pwrite(memory, from, size, static_cast<off_t>(at));
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) throw system_error("cannot write", "shared memory", errno);
        from += count;
        at += static_cast<std::uint64_t>(count);
        size -= static_cast<std::size_t>(count);
    }
}

void SharedSink::shape(const StoredShape& shape) {
    shape_ = shape;
}

void SharedSink::bytes(const void* data, std::size_t size) {
    write_at(memory_, data, size, begin_after(joined(shape_).size()) + written_);
    written_ += size;
}

void SharedSink::finish(const std::string& problem) {
    const std::string text = problem.empty() ? joined(shape_) : problem.substr(0, longest_text);
    if (!problem.empty() && ftruncate(memory_, 0) != 0)
        throw system_error("cannot write", "shared memory", errno);
    write_at(memory_, text.data(), text.size(), sizeof(Header));
    Header header{};
    header.mark = mark;
    header.content = !problem.empty()   ? Content::problem
                     : shape_.width > 0 ? Content::picture
                                        : Content::file;
    header.width = static_cast<std::uint32_t>(shape_.width);
    header.height = static_cast<std::uint32_t>(shape_.height);
    header.channels = static_cast<std::uint32_t>(shape_.channels);
    header.type = shape_.type;
    header.premultiplied = shape_.premultiplied ? 1 : 0;
    header.orientation = static_cast<std::uint32_t>(shape_.orientation);
    header.extra_channels = static_cast<std::uint32_t>(shape_.extra_names.size());
    header.notes = static_cast<std::uint32_t>(shape_.notes.size());
    header.text_size = static_cast<std::uint32_t>(text.size());
    header.size = problem.empty() ? written_ : 0;
    write_at(memory_, &header, sizeof header, 0);
}

SharedResult read_shared(int memory) {
    SharedResult result;
    struct stat status {};
    Header header{};
    if (fstat(memory, &status) != 0) throw system_error("cannot read", "shared memory", errno);
    const auto size = static_cast<std::uint64_t>(status.st_size);
    if (size >= sizeof header) read_at(memory, &header, sizeof header, 0);
    result.problem = "the process that reads pictures gave no picture";
    if (!is_valid(header, size)) return result;
    std::string text(header.text_size, '\0');
    read_at(memory, text.data(), text.size(), sizeof header);
    if (header.content == Content::problem) {
        result.problem = printable(text);
        return result;
    }
    result.first = begin_after(header.text_size);
    result.size = header.size;
    if (header.content == Content::picture) {
        StoredShape& shape = result.shape;
        if (!split(text, header, shape)) return result;
        for (std::string& name : shape.extra_names) name = printable(name);
        shape.width = static_cast<int>(header.width);
        shape.height = static_cast<int>(header.height);
        shape.channels = static_cast<int>(header.channels);
        shape.type = header.type;
        shape.premultiplied = header.premultiplied != 0;
        shape.orientation = static_cast<int>(header.orientation);
    }
    result.problem.clear();
    return result;
}

std::string shared_bytes(int memory, const SharedResult& result) {
    std::string bytes(result.size, '\0');
    read_at(memory, bytes.data(), bytes.size(), result.first);
    return bytes;
}

Image shared_image(int memory, const SharedResult& result, ColorSpace space) {
    switch (result.shape.type) {
        case SampleType::uint8:
            return decoded<std::uint8_t>(memory, result, space);
        case SampleType::uint16:
            return decoded<std::uint16_t>(memory, result, space);
        case SampleType::float32:
            return decoded<float>(memory, result, space);
        case SampleType::float64:
            return decoded<double>(memory, result, space);
    }
    return {};
}

}  // namespace lancer::io
