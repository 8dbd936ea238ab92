// Sums up what the limits of the recursion leave out.
#pragma once

#include <vector>

#include "tracer/shading/surface.h"
#include "tracer/shading/unrecorded.h"

namespace lancer {

/// Adds the factors along the way to each branch that is not followed: such a branch brings at most
/// that share of whatever light it would meet. A ray's weight will not do: it is tinted by total
/// reflections, and light is not (docs/shading.md). No light is formed on the way.
template <class Real>
class CutRecorder : public Unrecorded {
  public:
    static constexpr bool wants_light = false;

    /// \param share  gets the sum; must outlive this
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
    /// What reflects nothing adds nothing.
    void skip_mirrored(const Vec3<Real>& mirror, Real) { *share_ += at_surface_ * mirror; }
    void end_at_limit(const Vec3<Real>& through, Real, int) {
        *share_ += factors_.back() * through;
    }
    void end_after_surfaces(const Vec3<Real>& through) { *share_ += factors_.back() * through; }

  private:
    void begin_call(const Vec3<Real>& factor) { factors_.push_back(factor); }

    Vec3<Real>* share_;
    std::vector<Vec3<Real>> factors_;  ///< of the calls that have not ended
    Vec3<Real> at_surface_{};
};

}  // namespace lancer
