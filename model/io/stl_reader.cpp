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

bool is_binary(std::string_view bytes, const std::string& name) {
    return bytes.size() >= header_bytes + 4 &&
           bytes.size() == header_bytes + 4 + triangle_bytes * count_of(bytes, name);
}

PolygonSoup read_binary(std::string_view bytes, const std::string& name) {
    PolygonSoup soup;
    VertexMerger merger(soup.vertices);
    ByteReader reader(bytes, name, std::endian::little);
    reader.skip(header_bytes);
    const std::uint32_t count = reader.read<std::uint32_t>();
    if (count > none / 3) throw reader.error("there are too many triangles");
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
        // Writers put what they like there, even NaN; nobody needs it.
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

    /// The next word in small letters, on this line or a later one.
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
    if (first == "solid" || first == "SOLID" || first == "Solid") {
        return TextReader(bytes, name).read();
    }
    if (bytes.size() < header_bytes + 4) {
        throw FileError(fmt::format("{}: byte {}: the file is truncated", name, bytes.size()));
    }
    throw FileError(
        fmt::format("{}: byte {}: the file has {} bytes, but {} triangles need {}", name,
                    header_bytes, bytes.size(), count_of(bytes, name),
                    header_bytes + 4 + triangle_bytes * std::size_t{count_of(bytes, name)}));
}

}  // namespace lancer::io
