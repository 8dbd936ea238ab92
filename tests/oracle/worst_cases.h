// Cases in which a kernel came closest to its error bound, or once exceeded it. They are kept as
// tests.
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
    {"sphere", 641991},
    {"sphere, from its surface", 57830},
    {"sphere, from its surface", 788540},
    {"sphere, from its surface", 1448238},  // the rounding of the quotient was forgotten
    {"sphere, from its surface", 1923256},
    {"box", 827},
    {"box", 328159},
    {"plane", 7991},
    {"plane", 289307},
    {"triangle", 8506},
    {"triangle", 102676},
    {"cylinder and cone, side", 53037},
    {"cylinder and cone, side", 4558},  // the apex of a cone from far away: its radius was tilted
    {"cylinder and cone, side", 458370},
    {"cylinder and cone, from the side", 2311},  // along the axis: the rounding of the direction
    {"cylinder and cone, from the side", 256623},
    {"lathe", 40541},
    {"lathe", 5107},  // a direction whose square underflows
    {"lathe", 17203},
    {"lathe", 518285},
    {"prism", 7406},
    {"prism", 78710},
    {"patch", 40176},
    {"patch", 641232},
};

}  // namespace lancer::oracle
