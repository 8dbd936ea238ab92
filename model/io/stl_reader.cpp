#include "model/io/stl_reader.h"

#include <fmt/format.h>

#include "model/io/byte_reader.h"
#include "model/io/text_scanner.h"
#include "model/io/vertex_merger.h"

namespace lancer::io {
namespace {

constexpr std::size_t header_bytes = 80;
constexpr std::size_t triangle_bytes = 50;

std::uint32_t count_of(std::string_view bytes, const std::string& name) {
    ByteReader reader(bytes, name, std::endian::little);
    reader.skip(header_bytes);
    return reader.read<std::uint32_t>();
}

std::size_t bytes_of(std::uint32_t triangles) {
    return header_bytes + 4 + triangle_bytes * std::size_t{triangles};
}

/// A text contains no NUL; the header of a binary file nearly always does.
bool is_text(std::string_view bytes) {
    const std::string_view word = bytes.substr(0, 5);
    return (word == "solid" || word == "SOLID" || word == "Solid") &&
           bytes.substr(0, header_bytes + 4).find('\0') == std::string_view::npos;
}

std::string size_problem(std::string_view bytes, const std::string& name) {
    return fmt::format("{}: byte {}: the file has {} bytes, but {} triangles need {}", name,
                       header_bytes, bytes.size(), count_of(bytes, name),
                       bytes_of(count_of(bytes, name)));
}

/// Decides by the length. A file with more bytes than its triangles need is binary, too, unless it
/// is a text.
bool is_binary(std::string_view bytes, const std::string& name) {
    if (bytes.size() < header_bytes + 4) return false;
    const std::uint32_t count = count_of(bytes, name);
    return bytes.size() == bytes_of(count) ||
           (bytes.size() > bytes_of(count) && count > 0 && !is_text(bytes));
}

PolygonSoup read_binary(std::string_view bytes, const std::string& name) {
    PolygonSoup soup;
    VertexMerger merger(soup.vertices);
    ByteReader reader(bytes, name, std::endian::little);
    reader.skip(header_bytes);
    const std::uint32_t count = reader.read<std::uint32_t>();
    if (count > none / 3) throw reader.error("there are too many triangles");
    if (bytes.size() > bytes_of(count))
        soup.warnings.push_back(size_problem(bytes, name) + ": the rest is skipped");
    soup.corners.reserve(std::size_t{3} * count);
    for (std::uint32_t i = 0; i < count; ++i) {
        reader.skip(12);  // the normal
        for (int corner = 0; corner < 3; ++corner) {
            const double x = reader.read<float>();
            const double y = reader.read<float>();
            const double z = reader.read<float>();
            const Vec3d vertex(x, y, z);
            if (!is_finite(vertex)) throw reader.error("a coordinate is not finite");
            soup.corners.push_back(merger.index_of(vertex));
        }
        reader.skip(2);  // the attribute byte count
    }
    return soup;
}

class TextReader {
  public:
    TextReader(std::string_view bytes, const std::string& name) : scanner_(bytes, name) {}

    PolygonSoup read() {
        VertexMerger merger(soup_.vertices);
        // A file may hold several solids.
        do {
            expect("solid");
            scanner_.next_line();  // the name
            std::string_view next = word();
            while (next == "facet") {
                soup_.face_lines.push_back(scanner_.line());
                facet(merger);
                next = word();
            }
            if (next != "endsolid") throw expected("facet' or 'endsolid", next);
            scanner_.next_line();
        } while (!scanner_.at_end());
        return std::move(soup_);
    }

  private:
    void facet(VertexMerger& merger) {
        expect("normal");
        // Some writers put arbitrary values there, even NaN; the normal is not used.
        for (int i = 0; i < 3; ++i) word();
        expect("outer");
        expect("loop");
        for (int corner = 0; corner < 3; ++corner) {
            expect("vertex");
            const double x = scanner_.number("a coordinate");
            const double y = scanner_.number("a coordinate");
            const double z = scanner_.number("a coordinate");
            soup_.corners.push_back(merger.index_of({x, y, z}));
        }
        expect("endloop");
        expect("endfacet");
    }

    /// The next word in lower case, on this line or a later one.
    std::string_view word() {
        scanner_.at_end();
        word_ = scanner_.word();
        for (char& c : word_) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        return word_;
    }

    void expect(const char* keyword) {
        const std::string_view found = word();
        if (found != keyword) throw expected(keyword, found);
    }

    FileError expected(const char* keyword, std::string_view found) {
        if (found.empty()) return scanner_.error("the file is truncated");
        return scanner_.error(fmt::format("'{}' expected, not '{}'", keyword, quotable(found)));
    }

    TextScanner scanner_;
    std::string word_;
    PolygonSoup soup_;
};

}  // namespace

PolygonSoup read_stl(std::string_view bytes, const std::string& name) {
    if (is_binary(bytes, name)) return read_binary(bytes, name);
    TextScanner scanner(bytes, name);
    scanner.at_end();
    const std::string_view first = scanner.word();
    const bool begins_as_text = first == "solid" || first == "SOLID" || first == "Solid";
    const bool has_head = bytes.size() >= header_bytes + 4;
    if (begins_as_text && (!has_head || !bytes.starts_with(first) || is_text(bytes)))
        return TextReader(bytes, name).read();
    if (!has_head)
        throw FileError(fmt::format("{}: byte {}: the file is truncated", name, bytes.size()));
    throw FileError(size_problem(bytes, name));
}

}  // namespace lancer::io
