// Reads the header of a PLY file: its elements and their properties.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace lancer::io {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::float32;  ///< of a list: of its items
    bool is_list = false;
    PlyType count_type = PlyType::uint8;
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    enum class Format { ascii, little_endian, big_endian };
    Format format = Format::ascii;
    std::vector<PlyElement> elements;
    std::size_t bytes = 0;    ///< length of the header: where the data begin
    std::uint32_t lines = 0;  ///< of the header
};

/// Throws FileError, which names `name` and the line.
PlyHeader read_ply_header(std::string_view bytes, const std::string& name);

std::size_t size_of(PlyType type);

}  // namespace lancer::io
