#include "model/io/ply_reader.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "model/io/ply_data.h"
#include "model/srgb.h"

namespace lancer::io {
namespace {

/// Where a property of a vertex goes.
enum class Target { skipped, x, y, z, nx, ny, nz, u, v, red, green, blue };
constexpr std::size_t target_count = 12;

Target target_of(const PlyProperty& property) {
    constexpr std::array<std::pair<std::string_view, Target>, 20> names{{
        {"x", Target::x},
        {"y", Target::y},
        {"z", Target::z},
        {"nx", Target::nx},
        {"ny", Target::ny},
        {"nz", Target::nz},
        {"s", Target::u},
        {"t", Target::v},
        {"u", Target::u},
        {"v", Target::v},
        {"texture_u", Target::u},
        {"texture_v", Target::v},
        {"texture_s", Target::u},
        {"texture_t", Target::v},
        {"red", Target::red},
        {"green", Target::green},
        {"blue", Target::blue},
        {"diffuse_red", Target::red},
        {"diffuse_green", Target::green},
        {"diffuse_blue", Target::blue},
    }};
    if (property.is_list) return Target::skipped;
    for (const auto& [name, target] : names) {
        if (property.name == name) return target;
    }
    return Target::skipped;
}

/// The linear light of a colour component. Integers are steps of an sRGB picture; floats are
/// already linear.
double light_of(double value, PlyType type) {
    if (type == PlyType::uint8) return srgb_decode(value / 255);
    if (type == PlyType::uint16) return srgb_decode(value / 65535);
    return value;
}

template <class Data>
class PlyReader {
  public:
    PlyReader(Data data, const std::string& name) : data_(std::move(data)), name_(name) {}

    PolygonSoup read(const PlyHeader& header) {
        bool has_vertices = false;
        bool has_faces = false;
        for (const PlyElement& element : header.elements) {
            check_count(element);
            if (element.name == "vertex" && !has_vertices) {
                vertices(element);
                has_vertices = true;
            } else if (element.name == "face" && !has_faces) {
                faces(element);
                has_faces = true;
            } else if (element.name == "tristrips") {
                strips(element);
            } else {
                for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
                    for (const PlyProperty& property : element.properties) skip(property);
                }
            }
        }
        if (!has_vertices) throw FileError(fmt::format("{}: there are no vertices", name_));
        return std::move(soup_);
    }

  private:
    /// Checks the count, so that no memory or time is spent on more elements than the file can
    /// hold.
    void check_count(const PlyElement& element) const {
        for (const PlyProperty& property : element.properties) {
            const PlyType type = property.is_list ? property.count_type : property.type;
            if (element.count > data_.most_numbers_left(type)) {
                throw data_.error(
                    fmt::format("the file is truncated: it cannot hold {} elements "
                                "'{}'",
                                element.count, quotable(element.name)));
            }
        }
        if (element.count >= none) {
            throw data_.error(fmt::format("{} elements '{}' are too many", element.count,
                                          quotable(element.name)));
        }
    }

    void vertices(const PlyElement& element) {
        std::array<bool, target_count> given{};
        std::vector<Target> targets;
        for (const PlyProperty& property : element.properties) {
            targets.push_back(target_of(property));
            given[static_cast<std::size_t>(targets.back())] = true;
        }
        const auto has = [&](Target target) { return given[static_cast<std::size_t>(target)]; };
        if (!has(Target::x) || !has(Target::y) || !has(Target::z)) {
            throw FileError(fmt::format("{}: the vertices lack x, y or z", name_));
        }
        const bool normals = has(Target::nx) && has(Target::ny) && has(Target::nz);
        const bool uvs = has(Target::u) && has(Target::v);
        const bool colors = has(Target::red) && has(Target::green) && has(Target::blue);
        // An incomplete normal is ignored: its numbers are skipped and need not be finite.
        for (Target& target : targets) {
            if ((!normals && target >= Target::nx && target <= Target::nz) ||
                (!uvs && (target == Target::u || target == Target::v)) ||
                (!colors && target >= Target::red))
                target = Target::skipped;
        }
        soup_.vertices.reserve(element.count);
        for (std::uint64_t i = 0; i < element.count; ++i) {
            std::array<double, target_count> values{};
            for (std::size_t k = 0; k < targets.size(); ++k) {
                const PlyProperty& property = element.properties[k];
                if (targets[k] == Target::skipped) {
                    skip(property);
                } else {
                    double value = data_.number(property.type);
                    if (targets[k] >= Target::red) value = light_of(value, property.type);
                    if (!std::isfinite(value) || (targets[k] >= Target::red && value < 0))
                        note_bad(property.name, targets[k], i);
                    values[static_cast<std::size_t>(targets[k])] = value;
                }
            }
            const auto value = [&](Target target) {
                return values[static_cast<std::size_t>(target)];
            };
            soup_.vertices.emplace_back(value(Target::x), value(Target::y), value(Target::z));
            if (normals) {
                soup_.normals.emplace_back(value(Target::nx), value(Target::ny), value(Target::nz));
            }
            if (uvs) soup_.uvs.emplace_back(value(Target::u), value(Target::v));
            if (colors) {
                soup_.colors.emplace_back(value(Target::red), value(Target::green),
                                          value(Target::blue));
            }
        }
    }

    /// Records an error for faces that use the vertex.
    void note_bad(const std::string& property, Target target, std::uint64_t vertex) {
        auto& bad = target < Target::nx    ? soup_.bad_vertices
                    : target < Target::u   ? soup_.bad_normals
                    : target < Target::red ? soup_.bad_uvs
                                           : soup_.bad_colors;
        const std::string_view wrong =
            target < Target::red ? "not finite" : "negative or not finite";
        bad.emplace(
            static_cast<std::uint32_t>(vertex),
            data_.error(fmt::format("'{}' of vertex {} is {}", quotable(property), vertex, wrong))
                .what());
    }

    static bool is_corners(const PlyProperty& property) {
        return property.is_list &&
               (property.name == "vertex_indices" || property.name == "vertex_index");
    }

    void faces(const PlyElement& element) {
        for (std::uint64_t i = 0; i < element.count; ++i) {
            bool read = false;
            for (const PlyProperty& property : element.properties) {
                if (is_corners(property) && !read) {
                    corners(property, i);
                    read = true;
                } else {
                    skip(property);
                }
            }
            if (!read) {
                throw FileError(fmt::format("{}: the faces have no vertex_indices", name_));
            }
        }
    }

    /// Triangle strips: each corner makes a triangle with the two before it, reversed every other
    /// time; -1 begins a new strip. Repeated corners, which join strips, make none.
    void strips(const PlyElement& element) {
        for (std::uint64_t i = 0; i < element.count; ++i) {
            for (const PlyProperty& property : element.properties) {
                if (is_corners(property)) {
                    strip(property);
                } else {
                    skip(property);
                }
            }
        }
    }

    void strip(const PlyProperty& property) {
        const std::uint64_t count = length(property);
        std::array<std::uint32_t, 2> last{none, none};
        bool turned = false;
        for (std::uint64_t i = 0; i < count; ++i) {
            const double number = data_.number(property.type);
            if (number == -1) {
                last = {none, none};
                turned = false;
                continue;
            }
            if (!(number >= 0 && number < none) || number != std::floor(number))
                throw data_.error(
                    fmt::format("a vertex index of a strip is out of range: {}", number));
            const auto corner = static_cast<std::uint32_t>(number);
            if (last[0] != none) {
                const bool is_joint = corner == last[0] || corner == last[1] || last[0] == last[1];
                if (!is_joint) triangle(last[turned ? 1 : 0], last[turned ? 0 : 1], corner);
                turned = !turned;
            }
            last = {last[1], corner};
        }
    }

    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        if constexpr (requires { data_.line(); }) soup_.face_lines.push_back(data_.line());
        soup_.corners.insert(soup_.corners.end(), {a, b, c});
        soup_.face_ends.push_back(soup_.corners.size());
    }

    void corners(const PlyProperty& property, std::uint64_t face) {
        const std::uint64_t count = length(property);
        if (count < 3) {
            throw data_.error(
                fmt::format("face {} has {} corners, but needs at least 3", face, count));
        }
        if constexpr (requires { data_.line(); }) soup_.face_lines.push_back(data_.line());
        for (std::uint64_t i = 0; i < count; ++i) {
            const double index = data_.number(property.type);
            if (!(index >= 0 && index < none) || index != std::floor(index)) {
                throw data_.error(
                    fmt::format("a vertex index of face {} is out of range: {}", face, index));
            }
            soup_.corners.push_back(static_cast<std::uint32_t>(index));
        }
        soup_.face_ends.push_back(soup_.corners.size());
    }

    void skip(const PlyProperty& property) {
        data_.skip(property.type, property.is_list ? length(property) : 1);
    }

    std::uint64_t length(const PlyProperty& property) {
        const double count = data_.number(property.count_type);
        if (!(count >= 0)) throw data_.error("the length of a list is negative");
        if (count > static_cast<double>(data_.most_numbers_left(property.type))) {
            throw data_.error("the file is truncated");
        }
        return static_cast<std::uint64_t>(count);
    }

    Data data_;
    const std::string& name_;
    PolygonSoup soup_;
};

}  // namespace

PolygonSoup read_ply(std::string_view bytes, const std::string& name) {
    const PlyHeader header = read_ply_header(bytes, name);
    if (header.format == PlyHeader::Format::ascii) {
        return PlyReader(TextData(bytes, name, header), name).read(header);
    }
    return PlyReader(BinaryData(bytes, name, header), name).read(header);
}

}  // namespace lancer::io
