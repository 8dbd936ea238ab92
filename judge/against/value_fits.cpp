#include "judge/against/value_fits.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "model/srgb.h"

namespace lancer::judge {

namespace {

/// The least number of values for a fit.
constexpr std::size_t least_values = 16;

/// Applies a function to each of our values.
template <class Map>
std::vector<Color> mapped(const TrialPixels& samples, const Map& map) {
    std::vector<Color> colors = samples.ours;
    for (Color& color : colors)
        for (int c = 0; c < 3; ++c) color[c] = map(color[c], c);
    return colors;
}

/// The median of `ratio` over pairs of values (ours, theirs) in the open range, where neither is
/// clipped; nothing when there are too few. `channel` -1: all three channels.
template <class Ratio>
std::optional<double> median(const TrialPixels& samples, int channel, double least, double most,
                             const Ratio& ratio) {
    std::vector<double> values;
    for (std::size_t i = 0; i < samples.ours.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            if (channel >= 0 && c != channel) continue;
            const double a = samples.ours[i][c];
            const double b = samples.theirs[i][c];
            if (a > least && a < most && b > least && b < most) values.push_back(ratio(a, b));
        }
    }
    if (values.size() < least_values) return std::nullopt;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

double encoded(double v) {
    return v > 0 ? srgb_encode(v) : v;
}
double decoded(double v) {
    return v > 0 ? srgb_decode(v) : v;
}

std::optional<Explanation> another_exponent(const TrialPixels& samples) {
    const auto exponent = median(samples, -1, 0.02, 0.98, [](double a, double b) {
        return elementary::log(b) / elementary::log(a);
    });
    if (!exponent || !(*exponent > 0.05 && *exponent < 20) || std::abs(*exponent - 1) < 1e-3)
        return std::nullopt;
    return Explanation{
        fmt::format("its values are Lancer's to the power of {:.4g}: a gamma of {:.4g} is applied "
                    "(or undone), but should not be",
                    *exponent, *exponent < 1 ? 1 / *exponent : *exponent),
        mapped(samples, [&](double v, int) { return v > 0 ? elementary::pow(v, *exponent) : v; })};
}

std::optional<double> factor_of(const TrialPixels& samples, int channel) {
    const double most = samples.clipped ? 0.9999 : 1e300;
    return median(samples, channel, 0.01, most, [](double a, double b) { return b / a; });
}

std::optional<Explanation> another_exposure(const TrialPixels& samples) {
    const auto factor = factor_of(samples, -1);
    if (!factor || !(*factor > 0)) return std::nullopt;
    return Explanation{
        fmt::format("everything is {} times as bright as in Lancer's picture: another exposure "
                    "(--exposure {})",
                    factor_text(*factor), factor_text(*factor * samples.exposure)),
        mapped(samples, [&](double v, int) { return v * *factor; })};
}

std::optional<Explanation> another_white(const TrialPixels& samples) {
    std::array<double, 3> factors{1, 1, 1};
    for (int c = 0; c < 3; ++c) {
        const auto factor = factor_of(samples, c);
        if (!factor) return std::nullopt;
        factors[static_cast<std::size_t>(c)] = *factor;
    }
    return Explanation{
        fmt::format("red, green and blue are {}, {} and {} times Lancer's everywhere: another "
                    "white point or colour space",
                    factor_text(factors[0]), factor_text(factors[1]), factor_text(factors[2])),
        mapped(samples, [&](double v, int c) { return v * factors[static_cast<std::size_t>(c)]; })};
}

std::vector<Color> channels_turned(const TrialPixels& samples) {
    std::vector<Color> colors = samples.ours;
    for (Color& color : colors) std::swap(color.x, color.z);
    return colors;
}

}  // namespace

std::string factor_text(double factor) {
    std::string text = fmt::format("{:.5f}", factor);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.')) text.pop_back();
    return text;
}

std::vector<Explanation> value_fits(const TrialPixels& samples) {
    std::vector<Explanation> found;
    found.push_back(
        {"gamma is applied twice: the values are encoded by the sRGB curve once more than the file "
         "says (give --encoding srgb if it was read as linear)",
         mapped(samples, [](double v, int) { return encoded(v); })});
    found.push_back(
        {"gamma is missing: the file contains linear light, but is read as sRGB (give --encoding "
         "linear, or mark the file as linear, as a PNG is marked by gAMA 1)",
         mapped(samples, [](double v, int) { return decoded(v); })});
    found.push_back({"red and blue are exchanged", channels_turned(samples)});
    for (auto* fit : {another_exponent, another_exposure, another_white})
        if (auto explanation = fit(samples)) found.push_back(*std::move(explanation));
    return found;
}

}  // namespace lancer::judge
