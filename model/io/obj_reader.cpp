// We have a reader of our own because the known libraries accept nearly anything: tinyobjloader 2.0
// reads `v 1 abc 2` as (1, 0, 2) and accepts `v nan 0 0` without a message. A reference renderer
// must not render a file that it did not understand. docs/files.md has the measurements.
#include "model/io/obj_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include "model/io/text_scanner.h"

namespace lancer::io {
namespace {

/// Statements without triangles: groups, points and lines, free-form curves and surfaces.
constexpr std::array<std::string_view, 38> skipped_statements{
    "bevel",  "bmat",   "bsp",  "bzp",   "c_interp",  "call", "cdc",    "cdp", "con",  "csh",
    "cstype", "ctech",  "curv", "curv2", "d_interp",  "deg",  "end",    "g",   "hole", "l",
    "lod",    "maplib", "mg",   "o",     "p",         "parm", "res",    "s",   "scrv", "shadow_obj",
    "sp",     "stech",  "step", "surf",  "trace_obj", "trim", "usemap", "vp"};

class ObjReader {
  public:
    ObjReader(std::string_view bytes, const std::string& name, const ObjCounts& before,
              const ObjCounts& within)
        : scanner_(bytes, name, '#', '\\', before.lines + 1), before_(before) {
        soup_.vertices.reserve(within.vertices);
        soup_.uvs.reserve(within.uvs);
        soup_.normals.reserve(within.normals);
        soup_.corners.reserve(3 * within.faces);
        soup_.face_ends.reserve(within.faces);
        soup_.face_lines.reserve(within.faces);
    }

    ObjChunk read() {
        while (!scanner_.at_end()) {
            statement(scanner_.word());
            scanner_.next_line();
        }
        if (!chunk_.material) chunk_.first_faces = soup_.face_ends.size();
        return std::move(chunk_);
    }

  private:
    void statement(std::string_view keyword) {
        if (keyword == "v") {
            vertex();
        } else if (keyword == "vn") {
            soup_.normals.push_back(vector("a component of the normal",
                                           soup_.normals.size() + before_.normals,
                                           soup_.bad_normals));
        } else if (keyword == "vt") {
            const char* what = "a texture coordinate";
            const double u = scanner_.any_number(what);
            const double v = scanner_.at_line_end() ? 0 : scanner_.any_number(what);
            note_bad(std::isfinite(u) && std::isfinite(v), what, soup_.uvs.size() + before_.uvs,
                     soup_.bad_uvs);
            soup_.uvs.emplace_back(u, v);
        } else if (keyword == "f" || keyword == "fo") {
            face();
        } else if (keyword == "usemtl") {
            use_material(rest_of_statement());
        } else if (keyword == "mtllib") {
            soup_.libraries.push_back({rest_of_statement(), scanner_.line()});
        } else if (std::find(skipped_statements.begin(), skipped_statements.end(), keyword) ==
                   skipped_statements.end()) {
            throw scanner_.error("this is not a statement of an OBJ file");
        }
    }

    using Bad = std::map<std::uint32_t, std::string>;

    /// Records a number that is not finite, with its place. It is an error only where it is used.
    void note_bad(bool finite, const char* what, std::size_t index, Bad& bad) {
        if (!finite)
            bad.emplace(static_cast<std::uint32_t>(index),
                        scanner_.error(fmt::format("{} is not finite", what)).what());
    }

    /// Three more numbers are a colour in linear light; a single one is a weight. If only some
    /// vertices have a colour, the others are white, and the first of them causes a warning.
    void vertex() {
        const Vec3d place = coordinates("a coordinate", soup_.vertices.size() + before_.vertices,
                                        soup_.bad_vertices);
        std::array<double, 3> more{};
        std::size_t count = 0;
        for (; !scanner_.at_line_end(); ++count) {
            const double number = scanner_.any_number("a number");
            if (count < more.size()) more[count] = number;
        }
        if (count == 3) {
            const Vec3d color(more[0], more[1], more[2]);
            const bool is_light = is_finite(color) && color.x >= 0 && color.y >= 0 && color.z >= 0;
            soup_.colors.resize(soup_.vertices.size(), Vec3d(1.0));
            if (!is_light)
                soup_.bad_colors.emplace(
                    static_cast<std::uint32_t>(soup_.colors.size() + before_.vertices),
                    scanner_.error("the colour of this vertex is negative or not finite").what());
            soup_.colors.push_back(color);
        } else if (chunk_.colorless.empty()) {
            chunk_.colorless =
                scanner_.error("this vertex has no colour, but others have one: it becomes white")
                    .what();
        }
        soup_.vertices.push_back(place);
    }

    /// More numbers may follow on the line; they are only checked.
    Vec3d vector(const char* what, std::size_t at, Bad& bad) {
        const Vec3d read = coordinates(what, at, bad);
        while (!scanner_.at_line_end()) scanner_.any_number("a number");
        return read;
    }

    Vec3d coordinates(const char* what, std::size_t at, Bad& bad) {
        const double x = scanner_.any_number(what);
        const double y = scanner_.any_number(what);
        const double z = scanner_.any_number(what);
        const Vec3d read(x, y, z);
        note_bad(is_finite(read), what, at, bad);
        return read;
    }

    /// `f 1 2 3`, `f 1/1 2/2 3/3`, `f 1//1 2//2 3//3`, `f 1/1/1 2/2/2 3/3/3`. An index is missing
    /// when nothing follows its slash (`1//`, `1/1/`) or when there is no slash.
    void face() {
        const std::size_t begin = soup_.corners.size();
        soup_.face_lines.push_back(scanner_.line());
        while (!scanner_.at_line_end()) {
            soup_.corners.push_back(index(scanner_.integer("a vertex index"),
                                          soup_.vertices.size() + before_.vertices,
                                          "a vertex index"));
            std::uint32_t uv = none;
            std::uint32_t normal = none;
            if (scanner_.skip('/')) {
                uv = optional_index(soup_.uvs.size() + before_.uvs, "a texture vertex index");
                if (scanner_.skip('/'))
                    normal =
                        optional_index(soup_.normals.size() + before_.normals, "a normal index");
            }
            append(soup_.uv_corners, uv);
            append(soup_.normal_corners, normal);
        }
        if (soup_.corners.size() - begin < 3) {
            throw scanner_.error("a face needs at least three corners");
        }
        soup_.face_ends.push_back(soup_.corners.size());
        // Only files with materials need this list.
        if (soup_.materials.empty()) return;
        soup_.face_materials.resize(soup_.face_ends.size() - 1, none);
        soup_.face_materials.push_back(chunk_.material.value_or(none));
    }

    /// The text up to the end of the line or a comment, without surrounding blanks. Names may
    /// contain blanks.
    std::string rest_of_statement() {
        std::string rest;
        while (!scanner_.at_line_end())
            rest += (rest.empty() ? "" : " ") + std::string(scanner_.word());
        return rest;
    }

    void use_material(const std::string& name) {
        if (!chunk_.material) chunk_.first_faces = soup_.face_ends.size();
        chunk_.material = none;
        if (name.empty()) return;
        const auto [at, is_new] =
            numbers_.emplace(name, static_cast<std::uint32_t>(numbers_.size()));
        chunk_.material = at->second;
        if (is_new) soup_.materials.push_back(name);
    }

    /// The index counted from 0. An index that is too large is found later, because a file may list
    /// its faces first.
    std::uint32_t index(std::int64_t number, std::size_t count, const char* what) const {
        const std::int64_t index =
            number > 0 ? number - 1 : static_cast<std::int64_t>(count) + number;
        if (number == 0 || index < 0 || index >= before_the_first) {
            throw scanner_.error(
                fmt::format("{} is out of range: {} (there are {} so far)", what, number, count));
        }
        return static_cast<std::uint32_t>(index);
    }

    /// The index of a texture vertex or normal; `none` when it is missing.
    std::uint32_t optional_index(std::size_t count, const char* what) {
        if (scanner_.at_word_end() || scanner_.next_is('/')) return none;
        const std::int64_t number = scanner_.integer(what);
        // A relative index into a list that the file may not have at all.
        if (number < 0 && count == 0) return before_the_first;
        return index(number, count, what);
    }

    /// Most files never use the list, so it stays empty until it gets its first index.
    void append(std::vector<std::uint32_t>& corners, std::uint32_t index) {
        if (index == none && corners.empty()) return;
        corners.resize(soup_.corners.size() - 1, none);
        corners.push_back(index);
    }

    TextScanner scanner_;
    const ObjCounts before_;
    ObjChunk chunk_;
    PolygonSoup& soup_ = chunk_.soup;
    std::unordered_map<std::string, std::uint32_t> numbers_;  ///< of materials, by name
};

}  // namespace

ObjChunk read_obj_chunk(std::string_view bytes, const std::string& name, const ObjCounts& before,
                        const ObjCounts& within) {
    return ObjReader(bytes, name, before, within).read();
}

}  // namespace lancer::io
