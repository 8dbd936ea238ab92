// Chunks of an OBJ file put together.
#include <algorithm>
#include <unordered_map>

#include "model/io/obj_reader.h"

namespace lancer::io {
namespace {

class Join {
  public:
    PolygonSoup join(std::vector<ObjChunk> chunks) {
        if (chunks.size() == 1) {
            soup_ = std::move(chunks.front().soup);
            colorless_ = std::move(chunks.front().colorless);
        } else {
            reserve(chunks);
            for (ObjChunk& chunk : chunks) {
                add(chunk);
                chunk = {};
            }
        }
        soup_.first_index = 1;
        if (soup_.normal_corners.empty()) soup_.normals.clear();
        if (soup_.uv_corners.empty()) soup_.uvs.clear();
        if (!soup_.colors.empty()) {
            soup_.colors.resize(soup_.vertices.size(), Vec3d(1.0));
            if (!colorless_.empty() && soup_.bad_colors.empty())
                soup_.warnings.push_back(colorless_);
        }
        return std::move(soup_);
    }

  private:
    template <class Item>
    static void append(std::vector<Item>& all, const std::vector<Item>& more) {
        all.insert(all.end(), more.begin(), more.end());
    }

    void reserve(const std::vector<ObjChunk>& chunks) {
        const auto make_room = [&](auto list) {
            std::size_t count = 0;
            for (const ObjChunk& chunk : chunks) count += (chunk.soup.*list).size();
            (soup_.*list).reserve(count);
        };
        make_room(&PolygonSoup::vertices);
        make_room(&PolygonSoup::uvs);
        make_room(&PolygonSoup::normals);
        make_room(&PolygonSoup::corners);
        make_room(&PolygonSoup::face_ends);
        make_room(&PolygonSoup::face_lines);
    }

    void add(ObjChunk& chunk) {
        PolygonSoup& more = chunk.soup;
        if (!more.colors.empty()) {
            soup_.colors.resize(soup_.vertices.size(), Vec3d(1.0));
            append(soup_.colors, more.colors);
        }
        if (colorless_.empty()) colorless_ = std::move(chunk.colorless);
        append(soup_.vertices, more.vertices);
        append(soup_.uvs, more.uvs);
        append(soup_.normals, more.normals);
        add_materials(chunk);
        const std::size_t corners = soup_.corners.size();
        append(soup_.corners, more.corners);
        add_corners(soup_.uv_corners, more.uv_corners, corners);
        add_corners(soup_.normal_corners, more.normal_corners, corners);
        for (const std::uint64_t end : more.face_ends) soup_.face_ends.push_back(corners + end);
        append(soup_.face_lines, more.face_lines);
        std::move(more.libraries.begin(), more.libraries.end(),
                  std::back_inserter(soup_.libraries));
        soup_.bad_vertices.merge(more.bad_vertices);
        soup_.bad_normals.merge(more.bad_normals);
        soup_.bad_uvs.merge(more.bad_uvs);
        soup_.bad_colors.merge(more.bad_colors);
    }

    /// Either list is empty where it holds nothing but `none`. There were `before` corners.
    void add_corners(std::vector<std::uint32_t>& all, const std::vector<std::uint32_t>& more,
                     std::size_t before) const {
        if (all.empty() && more.empty()) return;
        all.resize(before, none);
        append(all, more);
        all.resize(soup_.corners.size(), none);
    }

    /// The list of materials begins, as if the file were one chunk, with the first face after the
    /// first name. Called before the chunk's faces are added.
    void add_materials(const ObjChunk& chunk) {
        const PolygonSoup& more = chunk.soup;
        std::vector<std::uint32_t> numbers;  // of the chunk's materials, in the file
        const bool had_names = !soup_.materials.empty();
        for (const std::string& name : more.materials) {
            const auto [at, is_new] =
                numbers_.emplace(name, static_cast<std::uint32_t>(numbers_.size()));
            numbers.push_back(at->second);
            if (is_new) soup_.materials.push_back(name);
        }
        const auto number = [&](std::uint32_t own) { return own == none ? none : numbers[own]; };
        const std::size_t faces = more.face_ends.size();
        if (faces > 0 && (had_names || !more.face_materials.empty())) {
            soup_.face_materials.resize(soup_.face_ends.size(), none);
            for (std::size_t face = 0; face < faces; ++face)
                soup_.face_materials.push_back(face < chunk.first_faces ? material_
                                               : more.face_materials.empty()
                                                   ? none
                                                   : number(more.face_materials[face]));
        }
        if (chunk.material) material_ = number(*chunk.material);
    }

    PolygonSoup soup_;
    std::string colorless_;
    std::unordered_map<std::string, std::uint32_t> numbers_;  ///< of materials, by name
    std::uint32_t material_ = none;                           ///< of the faces that follow
};

}  // namespace

PolygonSoup join_obj(std::vector<ObjChunk> chunks) {
    return Join().join(std::move(chunks));
}

}  // namespace lancer::io
