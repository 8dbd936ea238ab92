// How light fades inside of bodies: beer_lambert_transmittance() of shading/optics.h for lanes.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// Of eight ways, which are finite.
LANCER_INLINE Vectors beer_lambert_transmittance(const Vectors& absorption, const Numbers& way) {
    return {exponential(-absorption.x * way), exponential(-absorption.y * way),
            exponential(-absorption.z * way)};
}
/// The same for one lane, and a way that may be infinite.
inline void beer_lambert_transmittance(const double* absorption, double way, double* light) {
    constexpr double longest = 0x1.fffffffffffffp+1023;
    const double finite = way < longest ? way : longest;
    Numbers power = all(0.0);
    for (int c = 0; c < 3; ++c) set_lane(power, c, -absorption[c] * finite);
    const Numbers left = exponential(power);
    for (int c = 0; c < 3; ++c) light[c] = lane(left, c);
}

}  // namespace lancer::wide::LANCER_LEVEL
