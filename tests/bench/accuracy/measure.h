// The rows of tests/extremes through Lancer in its number types, POV-Ray and Tachyon.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tests/extremes/rows.h"

namespace lancer::bench {

enum class Program { lancer_double, lancer_single, lancer_extended, povray, tachyon };
inline constexpr std::array all_programs{Program::lancer_double, Program::lancer_single,
                                         Program::lancer_extended, Program::povray,
                                         Program::tachyon};
const char* name_of(Program program);

/// A program's pictures of one row.
struct Course {
    /// Wrong pixels by k, all of them where there is no picture.
    std::map<int, std::size_t> wrong;
    std::map<int, std::string> failures;  ///< why there is none
    std::string absent;                   ///< why the row is not for this program
};

struct MeasuredRow {
    extremes::Row row;
    std::size_t pixels = 0;  ///< of one picture
    std::map<Program, Course> courses;
};

struct Measurement {
    std::vector<MeasuredRow> rows;
    std::string povray_version;  ///< empty: not there
    bool tachyon = false;        ///< there
};

/// Renders everything: some minutes, less when POV-Ray's pictures are in the cache. `say` is told
/// what is being done.
Measurement measure(const std::vector<extremes::Row>& rows,
                    const std::function<void(const std::string&)>& say);

}  // namespace lancer::bench
