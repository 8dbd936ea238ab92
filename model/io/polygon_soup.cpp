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
        loaded_.mesh.faces.reserve(soup_.corners.size() / 3);
        const std::size_t faces =
            soup_.face_ends.empty() ? soup_.corners.size() / 3 : soup_.face_ends.size();
        std::size_t begin = 0;
        for (std::size_t face = 0; face < faces; ++face) {
            const std::size_t end = soup_.face_ends.empty() ? begin + 3 : soup_.face_ends[face];
            add(face, begin, end);
            begin = end;
        }
        Mesh& mesh = loaded_.mesh;
        mesh.vertices = std::move(soup_.vertices);
        mesh.normals = std::move(soup_.normals);
        mesh.uvs = std::move(soup_.uvs);
        simplify(mesh.normals, mesh.normal_faces);
        simplify(mesh.uvs, mesh.uv_faces);
        return std::move(loaded_);
    }

  private:
    void add(std::size_t face, std::size_t begin, std::size_t end) {
        check(face, begin, end, soup_.corners, soup_.vertices.size(), "vertex");
        check(face, begin, end, soup_.normal_corners, soup_.normals.size(), "normal");
        check(face, begin, end, soup_.uv_corners, soup_.uvs.size(), "texture vertex");
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
    }

    void check(std::size_t face, std::size_t begin, std::size_t end,
               const std::vector<std::uint32_t>& indices, std::size_t count,
               std::string_view what) const {
        if (indices.empty()) return;
        for (std::size_t i = begin; i < end; ++i) {
            if (indices[i] < count) continue;
            if (indices[i] == none && &indices != &soup_.corners) continue;
            throw FileError(fmt::format("{}: the face refers to {} {} of {} (counted from 0)",
                                        place(face), what, indices[i], count));
        }
    }

    void append(const std::vector<std::uint32_t>& indices, std::size_t begin,
                std::vector<Mesh::Corners>& faces) const {
        if (indices.empty()) return;
        for (const auto& [a, b, c] : triangles_) {
            faces.push_back({indices[begin + a], indices[begin + b], indices[begin + c]});
        }
    }

    /// Drops indices that say nothing: all `none`, or the same as those of the vertices.
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
    std::vector<Mesh::Corners> triangles_;
};

}  // namespace

LoadedMesh build_mesh(PolygonSoup soup, const std::string& name) {
    return Builder(soup, name).build();
}

}  // namespace lancer::io
