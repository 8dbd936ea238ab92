#include "model/io/polygon_soup.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "model/diagnostic.h"

namespace lancer::io {
namespace {

class Builder {
  public:
    Builder(PolygonSoup& soup, const std::string& name) : soup_(soup), name_(name) {}

    LoadedMesh build() {
        if (soup_.corners.empty()) throw FileError(fmt::format("{}: there are no faces", name_));
        if (std::max({soup_.vertices.size(), soup_.normals.size(), soup_.uvs.size()}) >= none) {
            throw FileError(fmt::format("{}: there are more than 2^32 vertices", name_));
        }
        loaded_.warnings = std::move(soup_.warnings);
        drop_absent(soup_.normals.empty(), soup_.normal_corners,
                    "names normals, but the file has none: they are averages of the faces");
        drop_absent(soup_.uvs.empty(), soup_.uv_corners,
                    "names texture coordinates, but the file has none");
        loaded_.mesh.faces.reserve(soup_.corners.size() / 3);
        const std::size_t faces =
            soup_.face_ends.empty() ? soup_.corners.size() / 3 : soup_.face_ends.size();
        std::size_t begin = 0;
        for (std::size_t face = 0; face < faces; ++face) {
            const std::size_t end = soup_.face_ends.empty() ? begin + 3 : soup_.face_ends[face];
            add(face, begin, end);
            begin = end;
        }
        // Vertices that no face uses are not part of the mesh, so they must not influence its size.
        for (const auto& [index, problem] : soup_.bad_vertices)
            soup_.vertices[index] = soup_.vertices[soup_.corners.front()];
        for (const auto& [index, problem] : soup_.bad_normals) soup_.normals[index] = Vec3d(0.0);
        for (const auto& [index, problem] : soup_.bad_uvs) soup_.uvs[index] = Vec2d(0.0);
        for (const auto& [index, problem] : soup_.bad_colors) soup_.colors[index] = Vec3d(0.0);
        if (!bad_color_.empty()) {
            loaded_.warnings.push_back(bad_color_ + ": the mesh is read without colours");
            soup_.colors.clear();
        }
        Mesh& mesh = loaded_.mesh;
        mesh.vertices = std::move(soup_.vertices);
        mesh.normals = std::move(soup_.normals);
        mesh.uvs = std::move(soup_.uvs);
        mesh.colors = std::move(soup_.colors);
        simplify(mesh.normals, mesh.normal_faces);
        simplify(mesh.uvs, mesh.uv_faces);
        number_materials();
        return std::move(loaded_);
    }

  private:
    /// Indices into a list that the file does not have are ignored, with one warning at the first.
    void drop_absent(bool absent, std::vector<std::uint32_t>& corners, std::string_view problem) {
        if (!absent || corners.empty()) return;
        const auto given = std::find_if(corners.begin(), corners.end(),
                                        [](std::uint32_t corner) { return corner != none; });
        const auto at = static_cast<std::uint64_t>(given - corners.begin());
        std::size_t face = at / 3;
        if (!soup_.face_ends.empty())
            face = static_cast<std::size_t>(
                std::upper_bound(soup_.face_ends.begin(), soup_.face_ends.end(), at) -
                soup_.face_ends.begin());
        loaded_.warnings.push_back(fmt::format("{}: the face {}", place(face), problem));
        corners.clear();
    }

    void add(std::size_t face, std::size_t begin, std::size_t end) {
        check(face, begin, end, soup_.corners, soup_.vertices.size(), "vertex");
        check(face, begin, end, soup_.normal_corners, soup_.normals.size(), "normal");
        check(face, begin, end, soup_.uv_corners, soup_.uvs.size(), "texture vertex");
        refuse_bad(begin, end, soup_.corners, soup_.bad_vertices);
        note_bad_color(begin, end);
        const bool own_normals = !soup_.normal_corners.empty();
        refuse_bad(begin, end, own_normals ? soup_.normal_corners : soup_.corners,
                   soup_.bad_normals);
        const bool own_uvs = !soup_.uv_corners.empty();
        refuse_bad(begin, end, own_uvs ? soup_.uv_corners : soup_.corners, soup_.bad_uvs);
        triangles_.clear();
        const std::span<const std::uint32_t> corners(soup_.corners.data() + begin, end - begin);
        try {
            if (!triangulate(soup_.vertices, corners, triangles_)) ++loaded_.degenerate;
        } catch (const FileError& error) {
            throw FileError(fmt::format("{}: {}", place(face), error.what()));
        }
        append(soup_.corners, begin, loaded_.mesh.faces);
        append(soup_.normal_corners, begin, loaded_.mesh.normal_faces);
        append(soup_.uv_corners, begin, loaded_.mesh.uv_faces);
        if (!soup_.face_materials.empty())
            loaded_.face_materials.insert(loaded_.face_materials.end(), triangles_.size(),
                                          soup_.face_materials[face]);
    }

    /// Numbers the materials in the order of their first triangles.
    void number_materials() {
        std::vector<std::uint32_t> order(soup_.materials.size() + 1, none);  // the last: no name
        for (std::uint32_t& material : loaded_.face_materials) {
            std::uint32_t& number = order[std::min<std::size_t>(material, soup_.materials.size())];
            if (number == none) {
                number = static_cast<std::uint32_t>(loaded_.materials.size());
                loaded_.materials.push_back(material == none ? "" : soup_.materials[material]);
            }
            material = number;
        }
        if (loaded_.materials.size() < 2) loaded_.face_materials = {};
        loaded_.libraries = std::move(soup_.libraries);
    }

    void check(std::size_t face, std::size_t begin, std::size_t end,
               const std::vector<std::uint32_t>& indices, std::size_t count,
               std::string_view what) const {
        if (indices.empty()) return;
        for (std::size_t i = begin; i < end; ++i) {
            if (indices[i] < count) continue;
            if (indices[i] == none && &indices != &soup_.corners) continue;
            // A relative index pointed before the first element; the reader could not decide this.
            const std::string number =
                indices[i] == before_the_first
                    ? "before the first"
                    : std::to_string(std::uint64_t{indices[i]} + soup_.first_index);
            throw FileError(fmt::format("{}: the face names {} {}, but there are {}{}", place(face),
                                        what, number, count,
                                        soup_.first_index == 0 ? ", counted from 0" : ""));
        }
    }

    static void refuse_bad(std::size_t begin, std::size_t end,
                           const std::vector<std::uint32_t>& indices,
                           const std::map<std::uint32_t, std::string>& bad) {
        if (bad.empty()) return;
        for (std::size_t i = begin; i < end; ++i)
            if (const auto at = bad.find(indices[i]); at != bad.end()) throw FileError(at->second);
    }

    /// A bad colour is only a warning, because colours are seldom shown.
    void note_bad_color(std::size_t begin, std::size_t end) {
        if (soup_.bad_colors.empty() || !bad_color_.empty()) return;
        for (std::size_t i = begin; i < end; ++i)
            if (const auto at = soup_.bad_colors.find(soup_.corners[i]);
                at != soup_.bad_colors.end())
                bad_color_ = at->second;
    }

    void append(const std::vector<std::uint32_t>& indices, std::size_t begin,
                std::vector<Mesh::Corners>& faces) const {
        if (indices.empty()) return;
        for (const auto& [a, b, c] : triangles_) {
            faces.push_back({indices[begin + a], indices[begin + b], indices[begin + c]});
        }
    }

    /// Drops redundant indices: all `none`, or equal to those of the vertices.
    template <class Attribute>
    void simplify(std::vector<Attribute>& attributes, std::vector<Mesh::Corners>& faces) const {
        const bool unused = std::all_of(faces.begin(), faces.end(), [](const Mesh::Corners& f) {
            return f == Mesh::Corners{none, none, none};
        });
        if (!faces.empty() && unused) {
            attributes = {};
            faces = {};
        }
        if (attributes.size() == loaded_.mesh.vertices.size() && faces == loaded_.mesh.faces) {
            faces = {};
        }
    }

    std::string place(std::size_t face) const {
        if (soup_.face_lines.empty()) return fmt::format("{}: face {}", name_, face);
        return fmt::format("{}:{}", name_, soup_.face_lines[face]);
    }

    PolygonSoup& soup_;
    const std::string& name_;
    LoadedMesh loaded_;
    std::string bad_color_;  ///< the problem of the first bad colour that a face uses
    std::vector<Mesh::Corners> triangles_;
};

}  // namespace

LoadedMesh build_mesh(PolygonSoup soup, const std::string& name) {
    return Builder(soup, name).build();
}

}  // namespace lancer::io
