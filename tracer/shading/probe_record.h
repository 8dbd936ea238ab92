// What a ray tells beside its colour, for tests and for the judge of pictures.
#pragma once

#include "tracer/shading/surface.h"

namespace lancer {

/// What a caller may want to know beside the colour. Members that are null are not collected.
template <class Real>
struct ProbeRecord {
    bool met = false;        ///< the ray met something
    bool settled = false;    ///< the first surface's lights are known
    Surface<Real> surface;   ///< the first surface met
    Real distance = 0;       ///< to it
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

/// For ProbeRecord::note(): this face of this primitive was met.
template <class Real>
std::uint64_t event_of(const Surface<Real>& s) {
    return s.id.primitive * std::uint64_t(31) + s.id.face;
}

}  // namespace lancer
