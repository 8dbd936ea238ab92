// Sums up how much light the limits of the recursion can leave out.
#pragma once

#include <vector>

#include "tracer/shading/surface.h"
#include "tracer/shading/unrecorded.h"

namespace lancer {

/// Adds up, over all branches that are not followed, the product of the factors on the path to the
/// branch. The branch would have contributed this share of the light that it meets. The ray's
/// weight cannot serve for this: a total reflection lowers it by the surface's tint, but does not
/// tint the light (docs/shading.md). No light is computed.
template <class Real>
class CutRecorder : public Unrecorded {
  public:
    static constexpr bool wants_light = false;

    /// \param share  receives the sum; must outlive this object
    explicit CutRecorder(Vec3<Real>& share) : share_(&share) {}

    void begin_camera_ray() { begin_call(Vec3<Real>(1)); }
    void begin_mirrored(const Vec3<Real>& through, const Vec3<Real>& passed,
                        const Vec3<Real>& mirror, Real) {
        begin_call(factors_.back() * through * passed * mirror);
    }
    void end_call() { factors_.pop_back(); }

    void shade(const Surface<Real>&, const Vec3<Real>& through, const Vec3<Real>& passed) {
        at_surface_ = factors_.back() * through * passed;
    }
    /// A surface without reflection has `mirror` 0 and adds nothing.
    void skip_mirrored(const Vec3<Real>& mirror, Real) { *share_ += at_surface_ * mirror; }
    void end_at_limit(const Vec3<Real>& through, Real, int) {
        *share_ += factors_.back() * through;
    }
    void end_after_surfaces(const Vec3<Real>& through) { *share_ += factors_.back() * through; }

  private:
    void begin_call(const Vec3<Real>& factor) { factors_.push_back(factor); }

    Vec3<Real>* share_;
    std::vector<Vec3<Real>> factors_;  ///< one per open call of the recursion
    Vec3<Real> at_surface_{};
};

}  // namespace lancer
