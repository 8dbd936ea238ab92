#include "model/io/ply_header.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "model/io/text_scanner.h"

namespace lancer::io {
namespace {

constexpr std::array<std::pair<std::string_view, PlyType>, 16> type_names{{
    {"char", PlyType::int8},
    {"int8", PlyType::int8},
    {"uchar", PlyType::uint8},
    {"uint8", PlyType::uint8},
    {"short", PlyType::int16},
    {"int16", PlyType::int16},
    {"ushort", PlyType::uint16},
    {"uint16", PlyType::uint16},
    {"int", PlyType::int32},
    {"int32", PlyType::int32},
    {"uint", PlyType::uint32},
    {"uint32", PlyType::uint32},
    {"float", PlyType::float32},
    {"float32", PlyType::float32},
    {"double", PlyType::float64},
    {"float64", PlyType::float64},
}};

class HeaderReader {
  public:
    HeaderReader(std::string_view bytes, const std::string& name)
        : size_(bytes.size()), scanner_(bytes, name) {}

    PlyHeader read() {
        if (scanner_.word() != "ply" || !scanner_.at_line_end()) {
            throw scanner_.error("a PLY file must start with the word ply");
        }
        scanner_.next_line();
        for (;;) {
            const std::string_view keyword = scanner_.word();
            if (keyword == "end_header") break;
            statement(keyword);
        }
        if (!has_format_) throw scanner_.error("the header names no format");
        scanner_.rest_of_line();  // only up to its end: binary data follow
        header_.bytes = size_ - scanner_.bytes_left();
        header_.lines = scanner_.line() - 1;
        return std::move(header_);
    }

  private:
    void statement(std::string_view keyword) {
        if (keyword == "comment" || keyword == "obj_info") {
            scanner_.next_line();
            return;
        }
        if (keyword == "format") {
            format();
        } else if (keyword == "element") {
            element();
        } else if (keyword == "property") {
            property();
        } else if (!keyword.empty()) {
            throw unknown("statement", keyword);
        } else if (scanner_.bytes_left() == 0) {
            throw scanner_.error("the file is truncated");
        }
        if (!scanner_.at_line_end()) throw unknown("word", scanner_.word());
        scanner_.next_line();
    }

    void format() {
        const std::string_view format = scanner_.word();
        using Format = PlyHeader::Format;
        if (format == "ascii") {
            header_.format = Format::ascii;
        } else if (format == "binary_little_endian") {
            header_.format = Format::little_endian;
        } else if (format == "binary_big_endian") {
            header_.format = Format::big_endian;
        } else {
            throw unknown("format", format);
        }
        const std::string_view version = scanner_.word();
        if (version != "1.0") throw unknown("version", version);
        has_format_ = true;
    }

    void element() {
        PlyElement element;
        element.name = scanner_.word();
        scanner_.at_line_end();
        const std::int64_t count = scanner_.integer("the number of elements");
        if (count < 0) throw scanner_.error("the number of elements is negative");
        element.count = static_cast<std::uint64_t>(count);
        header_.elements.push_back(std::move(element));
    }

    void property() {
        if (header_.elements.empty()) throw scanner_.error("a property must belong to an element");
        PlyProperty property;
        std::string_view type_name = scanner_.word();
        if (type_name == "list") {
            property.is_list = true;
            property.count_type = type(scanner_.word());
            if (property.count_type == PlyType::float32 ||
                property.count_type == PlyType::float64) {
                throw scanner_.error("the length of a list must be a whole number");
            }
            type_name = scanner_.word();
        }
        property.type = type(type_name);
        property.name = scanner_.word();
        if (property.name.empty()) throw scanner_.error("the property has no name");
        header_.elements.back().properties.push_back(std::move(property));
    }

    PlyType type(std::string_view name) const {
        for (const auto& [known, result] : type_names) {
            if (name == known) return result;
        }
        throw unknown("type", name);
    }

    FileError unknown(const char* what, std::string_view word) const {
        return scanner_.error(fmt::format("unknown {} '{}'", what, quotable(word)));
    }

    std::size_t size_;
    TextScanner scanner_;
    PlyHeader header_;
    bool has_format_ = false;
};

}  // namespace

PlyHeader read_ply_header(std::string_view bytes, const std::string& name) {
    return HeaderReader(bytes, name).read();
}

std::size_t size_of(PlyType type) {
    switch (type) {
        case PlyType::int8:
        case PlyType::uint8:
            return 1;
        case PlyType::int16:
        case PlyType::uint16:
            return 2;
        case PlyType::int32:
        case PlyType::uint32:
        case PlyType::float32:
            return 4;
        case PlyType::float64:
            return 8;
    }
    return 0;
}

}  // namespace lancer::io
