#include "judge/validate/exposure.h"

#include <algorithm>
#include <cmath>

namespace lancer::judge {

double exposure_for(const Image& image) {
    double brightest = 0;
    for (const double value : image.data) {
        if (std::isfinite(value)) brightest = std::max(brightest, value);
    }
    if (brightest <= 1) return 1;
    int exponent = 0;
    std::frexp(brightest, &exponent);  // brightest = m 2^exponent with m in [0.5, 1)
    return std::ldexp(1.0, -exponent);
}

double exposed(double value, double exposure) {
    return std::isfinite(value) ? std::clamp(value * exposure, 0.0, 1.0) : value;
}

}  // namespace lancer::judge
