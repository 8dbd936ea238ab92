// What follows the header of a PLY file, as a stream of numbers.
#pragma once

#include <cmath>
#include <string>
#include <string_view>

#include "model/io/byte_reader.h"
#include "model/io/ply_header.h"
#include "model/io/text_scanner.h"

namespace lancer::io {

/// The data of a text file as a stream of numbers.
class TextData {
  public:
    TextData(std::string_view bytes, const std::string& name, const PlyHeader& header)
        : scanner_(bytes.substr(header.bytes), name, 0, 0, header.lines + 1) {}

    double number(PlyType type) {
        if (scanner_.at_end()) throw scanner_.error("the file is truncated");
        const double value = scanner_.any_number("a number");
        if (type < PlyType::float32 && value != std::floor(value)) {
            throw scanner_.error("a whole number expected");
        }
        return value;
    }

    void skip(PlyType type, std::uint64_t count) {
        for (std::uint64_t i = 0; i < count; ++i) number(type);
    }

    /// The least that this many numbers need: a digit and a space each.
    std::uint64_t most_numbers_left(PlyType) const { return (scanner_.bytes_left() + 1) / 2; }
    std::uint32_t line() const { return scanner_.line(); }
    FileError error(const std::string& message) const { return scanner_.error(message); }

  private:
    TextScanner scanner_;
};

/// The data of a binary file as a stream of numbers.
class BinaryData {
  public:
    BinaryData(std::string_view bytes, const std::string& name, const PlyHeader& header)
        : reader_(bytes.substr(header.bytes), name,
                  header.format == PlyHeader::Format::little_endian ? std::endian::little
                                                                    : std::endian::big,
                  header.bytes) {}

    double number(PlyType type) {
        switch (type) {
            case PlyType::int8:
                return reader_.read<std::int8_t>();
            case PlyType::uint8:
                return reader_.read<std::uint8_t>();
            case PlyType::int16:
                return reader_.read<std::int16_t>();
            case PlyType::uint16:
                return reader_.read<std::uint16_t>();
            case PlyType::int32:
                return reader_.read<std::int32_t>();
            case PlyType::uint32:
                return reader_.read<std::uint32_t>();
            case PlyType::float32:
                return static_cast<double>(reader_.read<float>());
            case PlyType::float64:
                return reader_.read<double>();
        }
        return 0;
    }

    void skip(PlyType type, std::uint64_t count) {
        if (count > most_numbers_left(type)) throw error("the file is truncated");
        reader_.skip(count * size_of(type));
    }

    std::uint64_t most_numbers_left(PlyType type) const {
        return reader_.bytes_left() / size_of(type);
    }
    FileError error(const std::string& message) const { return reader_.error(message); }

  private:
    ByteReader reader_;
};

}  // namespace lancer::io
