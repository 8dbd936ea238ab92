// Transcendental functions that return the same bits on every processor.
//
// glibc chooses an implementation by CPU (with or without FMA), and the variants differ in the last
// bit, so a picture would depend on the machine. SLEEF's scalar functions "cinz" are defined to be
// bit-identical everywhere, within 1 ulp. They are used for float and double. long double and wider
// types, which judge the others, use the standard library (x87 code, one implementation). IEEE 754
// requires exact rounding of sqrt, fma, floor and the like, so these come from <cmath>.
#pragma once

namespace lancer::elementary {

#define LANCER_ELEMENTARY_1(name) \
    float name(float x);          \
    double name(double x);        \
    long double name(long double x);
#define LANCER_ELEMENTARY_2(name)    \
    float name(float x, float y);    \
    double name(double x, double y); \
    long double name(long double x, long double y);

LANCER_ELEMENTARY_1(sin)
LANCER_ELEMENTARY_1(cos)
LANCER_ELEMENTARY_1(tan)
LANCER_ELEMENTARY_1(asin)
LANCER_ELEMENTARY_1(acos)
LANCER_ELEMENTARY_1(atan)
LANCER_ELEMENTARY_1(exp)
LANCER_ELEMENTARY_1(log)
LANCER_ELEMENTARY_1(cbrt)
LANCER_ELEMENTARY_2(atan2)
LANCER_ELEMENTARY_2(pow)

#undef LANCER_ELEMENTARY_1
#undef LANCER_ELEMENTARY_2

/// sin and cos of an angle in degrees, exact at multiples of 90.
struct SineCosine {
    double sine = 0.0;
    double cosine = 1.0;
};
SineCosine sine_cosine_of_degrees(double degrees);

}  // namespace lancer::elementary
