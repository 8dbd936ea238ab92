// A number type of 113 bits (IEEE 754 binary128) for checking the others. The compiler provides the
// arithmetic, in software; glibc has the functions for this type.
//
// Include this before any header of tracer/. Its templates look up elementary::pow and the like
// where they are defined, not where they are used. Other functions are found by argument-dependent
// lookup.
#pragma once

#include <limits>
#include <numbers>
#include <type_traits>

#include "model/math.h"

namespace lancer {

/// Converts implicitly from every built-in number, since none has more bits; back only explicitly.
struct Quad {
    using Bits = __float128;

    Quad() = default;
    template <class T>
    requires std::is_arithmetic_v<T>
    constexpr Quad(T x) : bits(static_cast<Bits>(x)) {}
    static constexpr Quad of(Bits bits) {
        Quad q(0);
        q.bits = bits;
        return q;
    }

    template <class T>
    requires std::is_arithmetic_v<T>
    explicit constexpr operator T() const { return static_cast<T>(bits); }

    friend constexpr Quad operator+(Quad a) { return a; }
    friend constexpr Quad operator-(Quad a) { return of(-a.bits); }
    friend constexpr Quad operator+(Quad a, Quad b) { return of(a.bits + b.bits); }
    friend constexpr Quad operator-(Quad a, Quad b) { return of(a.bits - b.bits); }
    friend constexpr Quad operator*(Quad a, Quad b) { return of(a.bits * b.bits); }
    friend constexpr Quad operator/(Quad a, Quad b) { return of(a.bits / b.bits); }
    constexpr Quad& operator+=(Quad b) { return *this = *this + b; }
    constexpr Quad& operator-=(Quad b) { return *this = *this - b; }
    constexpr Quad& operator*=(Quad b) { return *this = *this * b; }
    constexpr Quad& operator/=(Quad b) { return *this = *this / b; }

    friend constexpr bool operator==(Quad a, Quad b) { return a.bits == b.bits; }
    friend constexpr bool operator<(Quad a, Quad b) { return a.bits < b.bits; }
    friend constexpr bool operator>(Quad a, Quad b) { return a.bits > b.bits; }
    friend constexpr bool operator<=(Quad a, Quad b) { return a.bits <= b.bits; }
    friend constexpr bool operator>=(Quad a, Quad b) { return a.bits >= b.bits; }

    Bits bits;
};

Quad sqrt(Quad x);
Quad fma(Quad a, Quad b, Quad c);
Quad abs(Quad x);
Quad copysign(Quad size, Quad sign);
Quad floor(Quad x);
Quad ldexp(Quad x, int exponent);
Quad frexp(Quad x, int* exponent);
int ilogb(Quad x);
bool isfinite(Quad x);
bool signbit(Quad x);

namespace elementary {
Quad sin(Quad x);
Quad cos(Quad x);
Quad tan(Quad x);
Quad asin(Quad x);
Quad acos(Quad x);
Quad atan(Quad x);
Quad atan2(Quad y, Quad x);
Quad exp(Quad x);
Quad pow(Quad x, Quad y);
}  // namespace elementary

}  // namespace lancer

template <>
class std::numeric_limits<lancer::Quad> {
    using Quad = lancer::Quad;

  public:
    static constexpr bool is_specialized = true;
    static constexpr bool is_signed = true;
    static constexpr bool is_integer = false;
    static constexpr bool is_exact = false;
    static constexpr bool is_iec559 = true;
    static constexpr bool is_bounded = true;
    static constexpr bool has_infinity = true;
    static constexpr bool has_quiet_NaN = true;
    static constexpr int radix = 2;
    static constexpr int digits = 113;
    static constexpr int min_exponent = -16381;
    static constexpr int max_exponent = 16384;

    // Those of long double where they are equal: the exponent has as many bits.
    static constexpr Quad epsilon() { return 0x1p-112; }
    static constexpr Quad min() { return numeric_limits<long double>::min(); }
    static constexpr Quad max() { return (2 - epsilon()) * 0x1p16383L; }
    static constexpr Quad lowest() { return -max(); }
    static constexpr Quad infinity() { return numeric_limits<double>::infinity(); }
    static constexpr Quad quiet_NaN() { return numeric_limits<double>::quiet_NaN(); }
};

/// The nearest number of 64 bits, plus the rest.
template <>
inline constexpr lancer::Quad std::numbers::pi_v<lancer::Quad> =
    lancer::Quad(std::numbers::pi_v<long double>) - 5.0165576126683320234517576e-20L;
