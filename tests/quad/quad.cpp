#include "tests/quad/quad.h"

// glibc's <cmath> declares these for some compilers only.
extern "C" {
using Bits = __float128;
Bits sqrtf128(Bits) noexcept;
Bits fmaf128(Bits, Bits, Bits) noexcept;
Bits floorf128(Bits) noexcept;
Bits ldexpf128(Bits, int) noexcept;
Bits frexpf128(Bits, int*) noexcept;
int ilogbf128(Bits) noexcept;
Bits copysignf128(Bits, Bits) noexcept;
Bits sinf128(Bits) noexcept;
Bits cosf128(Bits) noexcept;
Bits tanf128(Bits) noexcept;
Bits asinf128(Bits) noexcept;
Bits acosf128(Bits) noexcept;
Bits atanf128(Bits) noexcept;
Bits atan2f128(Bits, Bits) noexcept;
Bits expf128(Bits) noexcept;
Bits powf128(Bits, Bits) noexcept;
}

namespace lancer {

Quad sqrt(Quad x) {
    return Quad::of(sqrtf128(x.bits));
}
Quad fma(Quad a, Quad b, Quad c) {
    return Quad::of(fmaf128(a.bits, b.bits, c.bits));
}
Quad abs(Quad x) {
    return copysign(x, 1);
}
Quad copysign(Quad size, Quad sign) {
    return Quad::of(copysignf128(size.bits, sign.bits));
}
Quad floor(Quad x) {
    return Quad::of(floorf128(x.bits));
}
Quad ldexp(Quad x, int exponent) {
    return Quad::of(ldexpf128(x.bits, exponent));
}
Quad frexp(Quad x, int* exponent) {
    return Quad::of(frexpf128(x.bits, exponent));
}
int ilogb(Quad x) {
    return ilogbf128(x.bits);
}
bool isfinite(Quad x) {
    return abs(x) <= std::numeric_limits<Quad>::max();
}
bool signbit(Quad x) {
    return copysign(1, x) < 0;
}

namespace elementary {

Quad sin(Quad x) {
    return Quad::of(sinf128(x.bits));
}
Quad cos(Quad x) {
    return Quad::of(cosf128(x.bits));
}
Quad tan(Quad x) {
    return Quad::of(tanf128(x.bits));
}
Quad asin(Quad x) {
    return Quad::of(asinf128(x.bits));
}
Quad acos(Quad x) {
    return Quad::of(acosf128(x.bits));
}
Quad atan(Quad x) {
    return Quad::of(atanf128(x.bits));
}
Quad atan2(Quad y, Quad x) {
    return Quad::of(atan2f128(y.bits, x.bits));
}
Quad exp(Quad x) {
    return Quad::of(expf128(x.bits));
}
Quad pow(Quad x, Quad y) {
    return Quad::of(powf128(x.bits, y.bits));
}

}  // namespace elementary
}  // namespace lancer
