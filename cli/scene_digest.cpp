#include "cli/scene_digest.h"

#include <string_view>
#include <type_traits>

#include "base/sha256.h"
#include "model/shape_facts.h"

namespace lancer::cli {
namespace {

/// Structured bindings, here or in fields(), take every struct apart and name all its members: a
/// new member does not compile until it is added to the digest.
class SceneDigest {
  public:
    std::string digits() {
        flush();
        return digest_.digits();
    }

    template <class... Values>
    void all(const Values&... values) {
        (add(values), ...);
    }

    template <class Number>
    requires std::is_arithmetic_v<Number> || std::is_enum_v<Number>
    void add(const Number& number) { put(&number, sizeof number); }
    void add(const Vec2d& v) { all(v.x, v.y); }
    void add(const Vec3d& v) { all(v.x, v.y, v.z); }
    void add(const std::string& text) {
        add(text.size());
        put(text.data(), text.size());
    }

    template <class T>
    void add(const std::optional<T>& value) {
        add(value.has_value());
        if (value) add(*value);
    }
    template <class T>
    void add(const std::vector<T>& list) {
        add(list.size());
        for (const T& value : list) add(value);
    }
    template <class T, std::size_t N>
    void add(const std::array<T, N>& list) {
        for (const T& value : list) add(value);
    }
    template <class... Kinds>
    void add(const std::variant<Kinds...>& kind) {
        add(kind.index());
        std::visit([this](const auto& value) { this->add(value); }, kind);
    }
    template <class T>
    void add(const std::shared_ptr<const T>& shared) {
        add(*shared);
    }

    void add(const Affine<double>& s) {
        const auto& [rows, shift, shift_error] = s;
        all(rows, shift, shift_error);
    }
    void add(const OneShape auto& shape) {
        fields(shape, [this](std::string_view, const auto& value) { this->add(value); });
    }
    void add(const TriangleAttributes& s) {
        const auto& [normals, uvs] = s;
        all(normals, uvs);
    }
    void add(const Mesh& s) {
        const auto& [vertices, faces, normals, normal_faces, uvs, uv_faces, colors] = s;
        all(vertices, faces, normals, normal_faces, uvs, uv_faces, colors);
    }
    void add(const Patch& s) {
        const auto& [basis, rows, columns, control, tolerance] = s;
        all(basis, rows, columns, control, tolerance);
    }
    void add(const Lathe& s) {
        const auto& [profile, spline, tolerance] = s;
        all(profile, spline, tolerance);
    }
    void add(const Prism& s) {
        const auto& [outline, spline, bottom, top, capped, tolerance] = s;
        all(outline, spline, bottom, top, capped, tolerance);
    }

    void add(const ImageTexture& s) {
        const auto& [image, mapping, filter, wrap] = s;
        all(image, mapping, filter, wrap);
    }
    void add(const Checker& s) {
        const auto& [even, odd] = s;
        all(even, odd);
    }
    void add(const Gradient::Stop& s) {
        const auto& [at, color] = s;
        all(at, color);
    }
    void add(const Gradient& s) {
        const auto& [axis, stops] = s;
        all(axis, stops);
    }
    void add(const VertexColors&) {}
    void add(const Texture& s) {
        const auto& [pattern, to_object] = s;
        all(pattern, to_object);
    }
    void add(const Material& s) {
        const auto& [color, texture, ambient, diffuse, emission, phong, shininess, blinn, roughness,
                     metallic, reflection, fresnel, transmission, filter, ior, absorption,
                     diffuse_transmission, phong_transmission] = s;
        all(color, texture, ambient, diffuse, emission, phong, shininess, blinn, roughness,
            metallic, reflection, fresnel, transmission, filter, ior, absorption,
            diffuse_transmission, phong_transmission);
    }

    void add(const PerspectiveProjection& s) {
        const auto& [fov] = s;
        all(fov);
    }
    void add(const OrthographicProjection& s) {
        const auto& [height] = s;
        all(height);
    }
    void add(const Camera& s) {
        const auto& [name, position, look_at, up, projection, place] = s;
        all(position, look_at, up, projection);
    }
    void add(const Fade& s) {
        const auto& [distance, power] = s;
        all(distance, power);
    }
    void add(const PointLight& s) {
        const auto& [position, fade] = s;
        all(position, fade);
    }
    void add(const DirectionalLight& s) {
        const auto& [direction] = s;
        all(direction);
    }
    void add(const SpotLight& s) {
        const auto& [position, look_at, radius, falloff, tightness, fade] = s;
        all(position, look_at, radius, falloff, tightness, fade);
    }
    void add(const Light& s) {
        const auto& [kind, color, shadows, place] = s;
        all(kind, color, shadows);
    }
    void add(const Object& s) {
        const auto& [shape, material, transform, name, casts_shadow, place] = s;
        all(shape, material, transform, casts_shadow);
    }
    void add(const Composite::Place& s) {
        const auto& [parent, first] = s;
        all(parent, first);
    }
    void add(const Composite::Node& s) {
        const auto& [kind, place, begin, end] = s;
        all(kind, place, begin, end);
    }
    void add(const Composite::Leaf& s) {
        const auto& [object, place, texture_space] = s;
        all(object, place, texture_space);
    }
    void add(const Composite& s) {
        const auto& [nodes, leaves] = s;
        all(nodes, leaves);
    }

  private:
    void put(const void* bytes, std::size_t size) {
        waiting_.append(static_cast<const char*>(bytes), size);
        if (waiting_.size() > most_waiting) flush();
    }
    void flush() {
        digest_.add(waiting_);
        waiting_.clear();
    }

    static constexpr std::size_t most_waiting = std::size_t(1) << 16;
    Sha256 digest_;
    std::string waiting_;
};

}  // namespace

std::string scene_digest(const Scene& scene,
                         const std::function<std::string(const std::string& path)>& file) {
    const auto& [width, height, settings, background, sky, ambient, cameras, lights, objects,
                 materials, transforms, textures, images, meshes, triangle_attributes, patches,
                 lathes, prisms, composites, names, material_names] = scene;
    SceneDigest digest;
    digest.all(width, height, background, sky, ambient, cameras, lights, objects, materials,
               transforms, textures, meshes, triangle_attributes, patches, lathes, prisms,
               composites);
    for (const SceneImage& image : images) {
        const auto& [path, decode_srgb, pixels] = image;
        digest.all(file(path), decode_srgb);
    }
    return digest.digits();
}

}  // namespace lancer::cli
