// The names of precisions in scripts, options and reports.
#pragma once

#include <array>
#include <string_view>

#include "model/settings.h"

namespace lancer {

inline constexpr std::array all_precisions{Precision::single, Precision::double_,
                                           Precision::extended};

constexpr std::string_view name_of(Precision precision) {
    switch (precision) {
        case Precision::single:
            return "single";
        case Precision::double_:
            return "double";
        case Precision::extended:
            return "extended";
    }
    return "";
}

}  // namespace lancer
