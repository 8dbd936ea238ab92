#include "model/quality.h"

namespace lancer {

std::string_view name_of(Quality quality) {
    switch (quality) {
        case Quality::draft:
            return "draft";
        case Quality::normal:
            return "normal";
        case Quality::fine:
            return "fine";
        case Quality::exact:
            return "exact";
    }
    return "";
}

const QualityValues& values_of(Quality quality) {
    static constexpr QualityValues draft{1, Sampling::grid, 8, 0.03};
    static constexpr QualityValues normal{3, Sampling::sobol, 16, 0.01};
    static constexpr QualityValues fine{6, Sampling::sobol, 32, 0.003};
    static constexpr QualityValues exact{8, Sampling::sobol, 1000, 1e-12};
    switch (quality) {
        case Quality::draft:
            return draft;
        case Quality::normal:
            return normal;
        case Quality::fine:
            return fine;
        case Quality::exact:
            return exact;
    }
    return exact;
}

void apply(const QualityValues& values, Settings& settings) {
    settings.samples = values.samples;
    settings.sampling = values.sampling;
    settings.max_depth = values.max_depth;
    settings.min_contribution = values.min_contribution;
}

}  // namespace lancer
