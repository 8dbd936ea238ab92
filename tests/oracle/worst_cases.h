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
    {"sphere", 641991},
    {"sphere, from its surface", 57830},
    {"sphere, from its surface", 788540},
    {"sphere, from its surface", 1448238},  // the quotient's own rounding was left out
    {"sphere, from its surface", 1923256},
    {"box", 827},
    {"box", 328159},
    {"plane", 7991},
    {"plane", 289307},
    {"triangle", 8506},
    {"triangle", 102676},
    {"cylinder and cone, side", 53037},
    {"cylinder and cone, side", 4558},  // a cone's point, from far away: its radius was tilted
    {"cylinder and cone, side", 458370},
    {"cylinder and cone, from the side", 2311},  // along the axis: the direction's own rounding
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
