#include "reference/compare/flip.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <functional>
#include <numeric>

#include "model/elementary.h"
#include "model/math.h"

namespace lancer::reference {

namespace {

using elementary::exp;
using elementary::pow;

// ---- Colour spaces (paper, section 4.1.1 and its supplement)

/// Linear RGB with the primaries of sRGB (IEC 61966-2-1) to CIE XYZ. White is D65 with five digits,
/// (0.31271, 0.32902), and has Y = 1.
constexpr std::array<Vec3d, 3> rgb_to_xyz = {
    Vec3d{10135552.0 / 24577794.0, 8788810.0 / 24577794.0, 4435075.0 / 24577794.0},
    Vec3d{2613072.0 / 12288897.0, 8788810.0 / 12288897.0, 887015.0 / 12288897.0},
    Vec3d{1425312.0 / 73733382.0, 8788810.0 / 73733382.0, 70074185.0 / 73733382.0}};

Vec3d white_xyz() {
    const Vec3d one{1, 1, 1};
    return {dot(rgb_to_xyz[0], one), dot(rgb_to_xyz[1], one), dot(rgb_to_xyz[2], one)};
}

/// XYZ relative to white: (1, 1, 1) for white.
Vec3d relative_xyz(const Vec3d& rgb) {
    return Vec3d{dot(rgb_to_xyz[0], rgb), dot(rgb_to_xyz[1], rgb), dot(rgb_to_xyz[2], rgb)} /
           white_xyz();
}

/// The inverse of relative_xyz, by Cramer's rule on columns.
Vec3d rgb_from_relative_xyz(const Vec3d& relative) {
    const Vec3d xyz = relative * white_xyz();
    const auto& m = rgb_to_xyz;
    const Vec3d r{m[0].x, m[1].x, m[2].x};
    const Vec3d g{m[0].y, m[1].y, m[2].y};
    const Vec3d b{m[0].z, m[1].z, m[2].z};
    const double determinant = dot(r, cross(g, b));
    return Vec3d{dot(xyz, cross(g, b)), dot(r, cross(xyz, b)), dot(r, cross(g, xyz))} / determinant;
}

/// The linear opponent space YCxCz: achromatic, red-green, blue-yellow.
Vec3d ycxcz_from_rgb(const Vec3d& rgb) {
    const Vec3d n = relative_xyz(rgb);
    return {116 * n.y - 16, 500 * (n.x - n.y), 200 * (n.y - n.z)};
}

Vec3d rgb_from_ycxcz(const Vec3d& c) {
    const double y = (c.x + 16) / 116;
    return rgb_from_relative_xyz({y + c.y / 500, y, y - c.z / 200});
}

/// CIE L*a*b*, with a and b scaled by 0.01 L: the Hunt effect, chroma counts for less in the dark.
Vec3d hunt_lab_from_rgb(const Vec3d& rgb) {
    const auto f = [](double t) {
        constexpr double delta = 6.0 / 29.0;
        return t > delta * delta * delta ? elementary::cbrt(t)
                                         : t / (3 * delta * delta) + 4.0 / 29.0;
    };
    const Vec3d n = relative_xyz(rgb);
    const double l = 116 * f(n.y) - 16;
    return {l, 0.01 * l * (500 * (f(n.x) - f(n.y))), 0.01 * l * (200 * (f(n.y) - f(n.z)))};
}

/// HyAB: city-block in lightness, Euclidean in chroma (Abasi et al. 2020).
double hyab(const Vec3d& a, const Vec3d& b) {
    const Vec3d d = a - b;
    return std::abs(d.x) + std::sqrt(d.y * d.y + d.z * d.z);
}

// ---- Filters

/// One number per pixel.
struct Plane {
    int width = 0;
    int height = 0;
    std::vector<double> data;
};

/// Weights for the offsets -radius..radius.
using Kernel = std::vector<double>;

Kernel sampled(int radius, const std::function<double(double)>& weight) {
    Kernel kernel;
    for (int i = -radius; i <= radius; ++i) kernel.push_back(weight(i));
    return kernel;
}

/// Correlates each row with `kernel`. Beyond the border, the nearest pixel is used.
Plane filter_rows(const Plane& in, const Kernel& kernel) {
    const auto width = static_cast<std::size_t>(in.width);
    const std::size_t radius = kernel.size() / 2;
    Plane out{in.width, in.height, std::vector<double>(in.data.size())};
    std::vector<double> padded(width + 2 * radius);
    for (std::size_t begin = 0; begin < in.data.size(); begin += width) {
        const double* row = in.data.data() + begin;
        std::fill_n(padded.begin(), radius, row[0]);
        std::copy_n(row, width, padded.begin() + static_cast<std::ptrdiff_t>(radius));
        std::fill_n(padded.end() - static_cast<std::ptrdiff_t>(radius), radius, row[width - 1]);
        double* result = out.data.data() + begin;
        for (std::size_t k = 0; k < kernel.size(); ++k) {
            for (std::size_t x = 0; x < width; ++x) result[x] += kernel[k] * padded[x + k];
        }
    }
    return out;
}

/// The same for each column.
Plane filter_columns(const Plane& in, const Kernel& kernel) {
    const auto width = static_cast<std::size_t>(in.width);
    const int radius = static_cast<int>(kernel.size() / 2);
    Plane out{in.width, in.height, std::vector<double>(in.data.size())};
    for (int y = 0; y < in.height; ++y) {
        double* result = out.data.data() + static_cast<std::size_t>(y) * width;
        for (int k = -radius; k <= radius; ++k) {
            const double weight = kernel[static_cast<std::size_t>(k + radius)];
            const auto from = static_cast<std::size_t>(std::clamp(y + k, 0, in.height - 1));
            const double* row = in.data.data() + from * width;
            for (std::size_t x = 0; x < width; ++x) result[x] += weight * row[x];
        }
    }
    return out;
}

Plane filter(const Plane& in, const Kernel& along_x, const Kernel& along_y) {
    return filter_columns(filter_rows(in, along_x), along_y);
}

/// Contrast sensitivity of one opponent channel as a sum of Gaussians in the spatial domain,
/// a sqrt(pi / b) exp(-pi^2 d^2 / b) with d in degrees (paper, section 4.1.1, table 1).
struct Sensitivity {
    double a1, b1, a2, b2;
};
constexpr Sensitivity achromatic{1, 0.0047, 0, 1e-5};
constexpr Sensitivity red_green{1, 0.0053, 0, 1e-5};
constexpr Sensitivity blue_yellow{34.1, 0.04, 13.5, 0.025};

/// The filters of all channels have the same radius: three standard deviations of the widest.
int sensitivity_radius(double pixels_per_degree) {
    return static_cast<int>(
        std::ceil(3 * std::sqrt(blue_yellow.b1 / (2 * pi * pi)) * pixels_per_degree));
}

/// A two-dimensional Gaussian is a product of two one-dimensional ones, but a sum of Gaussians is
/// not. So each is filtered separately, then they are weighted. The whole two-dimensional kernel
/// sums to 1.
Plane apply_sensitivity(const Plane& in, const Sensitivity& s, double pixels_per_degree) {
    const int radius = sensitivity_radius(pixels_per_degree);
    const auto gaussian = [&](double b) {
        return sampled(radius, [&](double i) {
            const double d = i / pixels_per_degree;
            return exp(-pi * pi * d * d / b);
        });
    };
    const auto total = [](const Kernel& k) { return std::accumulate(k.begin(), k.end(), 0.0); };

    const Kernel first = gaussian(s.b1);
    const double weight1 = s.a1 * std::sqrt(pi / s.b1);
    Plane out = filter(in, first, first);
    double sum = weight1 * total(first) * total(first);
    for (double& value : out.data) value *= weight1;
    if (s.a2 != 0) {
        const Kernel second = gaussian(s.b2);
        const double weight2 = s.a2 * std::sqrt(pi / s.b2);
        const Plane other = filter(in, second, second);
        for (std::size_t i = 0; i < out.data.size(); ++i) out.data[i] += weight2 * other.data[i];
        sum += weight2 * total(second) * total(second);
    }
    for (double& value : out.data) value /= sum;
    return out;
}

// ---- The two halves of the metric

Vec3d clamped_rgb(const Image& image, std::size_t pixel) {
    const double* v = image.data.data() + pixel * static_cast<std::size_t>(image.channels);
    const bool grey = image.channels < 3;
    const auto clamp = [](double x) { return std::clamp(x, 0.0, 1.0); };
    return {clamp(v[0]), clamp(v[grey ? 0 : 1]), clamp(v[grey ? 0 : 2])};
}

/// The opponent channels of a picture.
std::array<Plane, 3> opponent_planes(const Image& image) {
    const auto pixels =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    std::array<Plane, 3> planes;
    for (Plane& plane : planes) plane = {image.width, image.height, std::vector<double>(pixels)};
    for (std::size_t i = 0; i < pixels; ++i) {
        const Vec3d c = ycxcz_from_rgb(clamped_rgb(image, i));
        planes[0].data[i] = c.x;
        planes[1].data[i] = c.y;
        planes[2].data[i] = c.z;
    }
    return planes;
}

/// The picture as the eye resolves it, in the space in which colour differences are measured.
std::vector<Vec3d> perceived_colors(const std::array<Plane, 3>& planes, double pixels_per_degree) {
    const Plane y = apply_sensitivity(planes[0], achromatic, pixels_per_degree);
    const Plane x = apply_sensitivity(planes[1], red_green, pixels_per_degree);
    const Plane z = apply_sensitivity(planes[2], blue_yellow, pixels_per_degree);
    std::vector<Vec3d> colors;
    colors.reserve(y.data.size());
    for (std::size_t i = 0; i < y.data.size(); ++i) {
        const Vec3d rgb = rgb_from_ycxcz({y.data[i], x.data[i], z.data[i]});
        colors.push_back(
            hunt_lab_from_rgb({std::clamp(rgb.x, 0.0, 1.0), std::clamp(rgb.y, 0.0, 1.0),
                               std::clamp(rgb.z, 0.0, 1.0)}));
    }
    return colors;
}

constexpr double color_exponent = 0.7;  // q_c

/// Maps a colour difference to 0..1. The largest possible one (green against blue) becomes 1. The
/// part below 40 % of it takes 95 % of the range, because larger differences all look equally
/// different.
double redistributed(double difference, double largest) {
    constexpr double p_c = 0.4;
    constexpr double p_t = 0.95;
    const double e = pow(difference, color_exponent);
    const double knee = p_c * largest;
    if (e < knee) return p_t / knee * e;
    return p_t + (e - knee) / (largest - knee) * (1 - p_t);
}

/// The strength of edges and points (lines, dots) in the achromatic channel, section 4.2:
/// derivatives of a Gaussian as wide as half a detected feature, whose positive and negative parts
/// are normalised to 1.
struct Features {
    Plane edges;
    Plane points;
};

Features find_features(const Plane& achromatic_plane, double pixels_per_degree) {
    constexpr double feature_width = 0.082;  // degrees
    const double deviation = 0.5 * feature_width * pixels_per_degree;
    const int radius = static_cast<int>(std::ceil(3 * deviation));
    const auto gauss = [&](double x) { return exp(-x * x / (2 * deviation * deviation)); };
    const auto normalised = [](Kernel kernel) {
        double positive = 0;
        double negative = 0;
        for (double w : kernel) (w > 0 ? positive : negative) += std::abs(w);
        for (double& w : kernel) w /= w > 0 ? positive : negative > 0 ? negative : 1.0;
        return kernel;
    };
    const Kernel smooth = normalised(sampled(radius, gauss));
    const Kernel first = normalised(sampled(radius, [&](double x) { return -x * gauss(x); }));
    const Kernel second = normalised(sampled(
        radius, [&](double x) { return (x * x / (deviation * deviation) - 1) * gauss(x); }));

    Plane y = achromatic_plane;
    for (double& value : y.data) value = (value + 16) / 116;
    const auto magnitude = [&](const Kernel& derivative) {
        Plane result = filter(y, derivative, smooth);
        const Plane vertical = filter(y, smooth, derivative);
        for (std::size_t i = 0; i < result.data.size(); ++i) {
            result.data[i] =
                std::sqrt(result.data[i] * result.data[i] + vertical.data[i] * vertical.data[i]);
        }
        return result;
    };
    return {magnitude(first), magnitude(second)};
}

}  // namespace

std::vector<double> flip_errors(const Image& reference, const Image& test,
                                double pixels_per_degree) {
    assert(reference.width == test.width && reference.height == test.height);
    const std::array<Plane, 3> planes_a = opponent_planes(reference);
    const std::array<Plane, 3> planes_b = opponent_planes(test);
    const std::vector<Vec3d> colors_a = perceived_colors(planes_a, pixels_per_degree);
    const std::vector<Vec3d> colors_b = perceived_colors(planes_b, pixels_per_degree);
    const Features features_a = find_features(planes_a[0], pixels_per_degree);
    const Features features_b = find_features(planes_b[0], pixels_per_degree);
    const double largest =
        pow(hyab(hunt_lab_from_rgb({0, 1, 0}), hunt_lab_from_rgb({0, 0, 1})), color_exponent);

    std::vector<double> errors;
    errors.reserve(colors_a.size());
    for (std::size_t i = 0; i < colors_a.size(); ++i) {
        const double color = redistributed(hyab(colors_a[i], colors_b[i]), largest);
        const double feature =
            std::max(std::abs(features_a.edges.data[i] - features_b.edges.data[i]),
                     std::abs(features_a.points.data[i] - features_b.points.data[i]));
        const double weight = std::min(1.0, std::sqrt(feature / std::sqrt(2.0)));  // q_f = 1/2
        errors.push_back(color > 0 ? pow(color, 1 - weight) : 0.0);
    }
    return errors;
}

double mean_flip(const Image& reference, const Image& test, double pixels_per_degree) {
    const std::vector<double> errors = flip_errors(reference, test, pixels_per_degree);
    return std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size());
}

}  // namespace lancer::reference
