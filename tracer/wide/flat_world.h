// A world as plain arrays, for code that must not call functions from elsewhere: wide/scene.h.
#pragma once

#include <array>
#include <map>
#include <utility>
#include <vector>

#include "tracer/scene/world.h"
#include "tracer/wide/scene.h"

namespace lancer::wide {

Tree tree_of(const Bvh<double>& bvh);

/// Holds pointers into the world and into itself, so it cannot be copied.
class FlatWorld {
  public:
    explicit FlatWorld(const World<double>& world);
    FlatWorld(const FlatWorld&) = delete;
    FlatWorld& operator=(const FlatWorld&) = delete;

    const Scene& scene() const { return scene_; }

  private:
    void add(const Primitive<double>& primitive, const World<double>& world);
    Item add_in_world(const Solid<double>& solid);
    void add(const MeshInstance<double>& instance, std::uint32_t frame);
    const MeshShape* shape_of(const MeshInstance<double>& instance);
    void add(const lancer::Finish<double>& finish, const World<double>& world);
    void add(const LightSource<double>& light, const World<double>& world);
    std::uint32_t frame_of_patch(std::uint32_t frame);
    void add_patterns(const World<double>& world);
    std::uint32_t add_texture(const Primitive<double>& primitive, const World<double>& world);

    std::vector<Item> items_;
    std::vector<Plane> planes_;
    std::vector<Mesh> meshes_;
    std::vector<MeshShape> mesh_shapes_;  ///< never moved
    std::map<std::pair<const TriangleMesh<double>*, bool>, const MeshShape*> shapes_of_meshes_;
    std::vector<Frustum> frustums_;
    std::vector<Torus> tori_;
    std::vector<Patch> patches_;
    std::map<std::array<double, 12>, std::uint32_t> frames_of_patches_;
    std::vector<std::uint32_t> medium_slots_;
    std::vector<Frame> frames_;  ///< as World::frames
    std::vector<Finish> finishes_;
    std::vector<std::uint32_t> texture_of_;
    std::vector<Texture> textures_;
    std::vector<Pattern> patterns_;  ///< as World::textures
    std::vector<Stop> stops_;        ///< of all gradients
    std::vector<Light> lights_;
    std::uint32_t finish_of_composites_ = 0;  ///< a finish that the exact methods shade
    Scene scene_{};
};

}  // namespace lancer::wide
