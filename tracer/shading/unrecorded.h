// The recorder of ordinary rendering, which records nothing.
#pragma once

namespace lancer {

/// Has the functions of RayTreeRecorder (tracer/recursion/ray_tree_recorder.h), which documents
/// them. They are empty here, so ordinary rendering does not pay for them.
struct Unrecorded {
    /// Whether local light is computed; if false, local_color() returns black.
    static constexpr bool wants_light = true;

    void begin_camera_ray() const {}
    void begin_mirrored(const auto&...) const {}
    void skip_mirrored(const auto&...) const {}
    void end_call() const {}
    void begin_bent(bool) const {}
    void start(const auto&...) const {}
    void end_at_limit(const auto&...) const {}
    void end_in_background(const auto&...) const {}
    void end_opaque() const {}
    void end_after_surfaces(const auto&...) const {}
    void meet(const auto&...) const {}
    void bend(const auto&...) const {}
    void shade(const auto&...) const {}
    void glow(const auto&...) const {}
    void ask_light(const auto&...) const {}
    void arrive(const auto&...) const {}
    void end_light(const auto&...) const {}
    void block(const auto&...) const {}
    void filter(const auto&...) const {}
    void absorb(const auto&...) const {}
};

inline constexpr Unrecorded unrecorded;

}  // namespace lancer
