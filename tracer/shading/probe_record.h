// What a ray met, beside its colour; for tests and for the judge.
#pragma once

#include "tracer/shading/surface.h"

namespace lancer {

/// What one ray met.
template <class Real>
struct ProbeRecord {
    bool met = false;        ///< the ray met something
    bool settled = false;    ///< `lit` is complete
    Surface<Real> surface;   ///< the first surface met
    Real distance = 0;       ///< to the first surface
    std::uint64_t lit = 0;   ///< Probe::lit
    std::uint64_t path = 0;  ///< Probe::path

    void remember(const Surface<Real>& s, Real t) {
        if (met) return;
        met = true;
        surface = s;
        distance = t;
    }
    void note(std::uint64_t event) { path = (path ^ event) * 0x9E3779B97F4A7C15u + (path >> 29); }
};

/// The event "this face of this primitive was met", for ProbeRecord::note().
template <class Real>
std::uint64_t event_of(const Surface<Real>& s) {
    return s.id.primitive * std::uint64_t(31) + s.id.face;
}

}  // namespace lancer
