// Cases in which a kernel used the most of its error bound, or once broke it, kept for good.
#pragma once

#include <cstdint>
#include <string_view>

namespace lancer::oracle {

struct WorstCase {
    std::string_view shape;  ///< as in the table
    std::uint64_t number;
};

inline constexpr WorstCase worst_cases[] = {
    {"sphere", 69861},
    {"sphere, from its surface", 57830},
    {"box", 827},
    {"plane", 7991},
    {"triangle", 8506},
    {"cylinder and cone, mantle", 53037},
    {"cylinder and cone, mantle", 4558},  // a cone's point, from far away: its radius was tilted
    {"lathe", 40541},
    {"lathe", 5107},  // a direction whose square underflows
    {"lathe", 17203},
    {"prism", 7406},
    {"patch", 40176},
};

}  // namespace lancer::oracle
