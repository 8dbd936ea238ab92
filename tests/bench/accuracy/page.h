// What was measured, as the generated section of docs/accuracy.md and its plot.
#pragma once

#include <string>

#include "tests/bench/accuracy/measure.h"

namespace lancer::bench {

/// The table in Markdown, followed by the rows that miss their aims.
std::string accuracy_section(const Measurement& measurement);

/// Wrong pixels against k, of the rows that are `plotted`. An SVG document.
std::string accuracy_plot(const Measurement& measurement);

/// `page` with everything between the two marker lines replaced. Throws FileError when a marker is
/// missing.
std::string with_section(const std::string& page, const std::string& section);

}  // namespace lancer::bench
