// Eight rays in the spaces of patches, and what is known of the surface that they start on.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// Eight rays in the space of a patch.
struct PatchRays {
    Rays rays;
    Vectors normal;  ///< of what the ray starts on, turned to the side that the ray goes to
    Mask steep;      ///< lanes in which it is known, and the ray does not go along the surface
    std::uint32_t frame = nothing;

    void set(const Scene& scene, std::uint32_t of, const Rays& world, const Starts& starts) {
        frame = of;
        const Frame& f = scene.frames[of];
        set(to_local(world, f), map_transposed(f.to_world, starts.normal), starts.planes);
    }
    void set(const Rays& local, const Vectors& given, Mask known) {
        rays = local;
        const Numbers zero = all(0.0);
        const Numbers rise = dot(given, local.dir);
        normal = select(less(rise, zero), -given, given);
        const Vectors size = absolute(given);
        steep = known &
                less(all(0x1p-14) * (size.x + size.y + size.z) * max_component(absolute(local.dir)),
                     absolute(rise));
    }
};

/// The same in the spaces of all patches that eight rays come to, of which many are alike.
class PatchSpaces {
  public:
    const PatchRays& rays_in(const Scene& scene, const Patch& patch, const Rays& world,
                             const Starts& starts) {
        if (patch.frame == nothing) {
            if (!is_set_) world_.set(world, starts.normal, starts.planes);
            is_set_ = true;
            return world_;
        }
        PatchRays& own = own_[patch.frame % spaces];
        if (own.frame != patch.frame) own.set(scene, patch.frame, world, starts);
        return own;
    }

  private:
    static constexpr int spaces = 4;
    PatchRays own_[spaces];
    PatchRays world_;
    bool is_set_ = false;
};

}  // namespace lancer::wide::LANCER_LEVEL
