// The crossings of a shadow ray with what filters its light, as one search collects them.
#pragma once

#include <boost/container/small_vector.hpp>

#include "tracer/rays/crossing.h"
#include "tracer/scene/geometry.h"

namespace lancer {

/// The crossings of a shadow ray with transmissive primitives.
template <class Real>
class Passes {
  public:
    struct Pass {
        Real t, error;
        std::uint32_t primitive;
        bool entering;
        bool touched;  ///< the ray starts on the primitive
    };

    /// In error bounds. Hits of one contact lie within two of them (NearestContact).
    static constexpr Real apart = 8;

    /// \param distance  to the light
    explicit Passes(Real distance) : distance_(distance) {}

    /// The end of the search, a little beyond the light: a crossing near the light may lie before
    /// it when another formula computes it.
    Real reach() const { return distance_ * (1 + Real(0x1p-20)); }

    /// Adds one crossing.
    ///
    /// \param touched  whether the ray starts on the primitive
    void add(const Geometry<Real>& geometry, std::uint32_t primitive, const Crossing<Real>& c,
             bool touched) {
        const Real margin = apart * c.error;
        if (c.t < -margin || c.t > distance_ + margin) return;
        const Primitive<Real>& p = geometry.primitives[primitive];
        const bool between = c.t > margin && c.t < distance_ - margin;
        if (!p.filters_evenly || !between || all_.size() == most || p.composite() != nullptr)
            clear_ = false;
        if (clear_) all_.push_back({c.t, c.error, primitive, c.entering, touched});
    }

  protected:
    static constexpr std::size_t most = 64;

    Real distance_;
    bool clear_ = true;  ///< all crossings are in `all_`, and one search is enough for each
    boost::container::small_vector<Pass, 16> all_;
};

}  // namespace lancer
