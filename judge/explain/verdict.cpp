#include "judge/explain/verdict.h"

#include <fmt/format.h>

#include <algorithm>

#include "reference/compare/compare.h"

namespace lancer::judge {

void measure_interior(Judgement& result, const Mask& edges, const std::vector<double>& differences,
                      const Thresholds& limits) {
    std::vector<double> interior;
    for (std::size_t i = 0; i < differences.size(); ++i) {
        const PixelClass c = result.classes[i];
        if (edges[i] == 0 && (c == PixelClass::agrees || c == PixelClass::unexplained)) {
            interior.push_back(differences[i]);
        }
    }
    result.interior_pixels = interior.size();
    if (interior.empty()) return;
    const auto within = std::count_if(interior.begin(), interior.end(),
                                      [&](double d) { return d <= limits.tight; });
    result.tight_share = static_cast<double>(within) / static_cast<double>(interior.size());
    result.interior_max = *std::max_element(interior.begin(), interior.end());
    result.interior_p999 = reference::percentile(interior, 0.999);
}

std::size_t allowed_pixels(double share, std::size_t of) {
    return std::max<std::size_t>(1, static_cast<std::size_t>(share * static_cast<double>(of)));
}

void decide(Judgement& result, const Thresholds& limits) {
    auto& failures = result.failures;
    const std::size_t unexplained = result.count(PixelClass::unexplained);
    if (unexplained > limits.unexplained) {
        failures.push_back(fmt::format("{} unexplained pixels differ by more than {:g}, {} allowed",
                                       unexplained, limits.interior, limits.unexplained));
        if (result.not_looked_at > 0) {
            failures.push_back(
                fmt::format("{} of them were not examined: explaining ended after {} rays",
                            result.not_looked_at, result.rays));
        }
    }
    if (result.tight_share < limits.tight_share) {
        failures.push_back(fmt::format(
            "{:.3f} % of the pixels away from edges are within {:g}, but {:g} % are needed",
            result.tight_share * 100, limits.tight, limits.tight_share * 100));
    }
    const std::size_t most = allowed_pixels(limits.explained_share, result.edge_pixels);
    if (result.explained > most) {
        failures.push_back(fmt::format(
            "{} pixels are explained by edges, at most {} are allowed ({:g} % of {} edge pixels)",
            result.explained, most, limits.explained_share * 100, result.edge_pixels));
    }
    const std::size_t most_displaced = allowed_pixels(limits.displaced_share, result.edge_pixels);
    if (result.displaced > most_displaced) {
        failures.push_back(fmt::format(
            "{} edges are more than {:g} pixel apart in the two pictures, at most {} are allowed",
            result.displaced, limits.rounding, most_displaced));
    }
    if (result.edge_shift.is_significant(limits.rounding, 3)) {
        failures.push_back(
            fmt::format("the edges that explain differences are all displaced to one side, by "
                        "({:.2g}, {:.2g}) pixel on average",
                        result.edge_shift.x, result.edge_shift.y));
    }
    if (result.picture_shift.is_significant(limits.shift, 5)) {
        result.shift_failure =
            fmt::format("the other picture is shifted by ({:.2g}, {:.2g}) pixel, {:g} allowed",
                        result.picture_shift.x, result.picture_shift.y, limits.shift);
        failures.push_back(result.shift_failure);
    }
    result.pass = failures.empty();
}

}  // namespace lancer::judge
