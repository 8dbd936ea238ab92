// Validations for the terminal, for JSON and for the report.
#pragma once

#include <string>
#include <vector>

#include "judge/report/junit.h"
#include "judge/report/report.h"
#include "judge/validate/validate.h"

namespace lancer::judge {

/// The head of the table and one line. `name_width` is the length of the longest name. `other` is
/// the heading of the column with the other program's time.
std::string table_head(std::size_t name_width, const std::string& other = "POV-Ray");
std::string table_row(const Validation& validation, std::size_t name_width);

/// {"povray", "verdict", "scenes": [{"name", "verdict", "reasons", "interior_max", ...}]}. Values
/// that were not measured are omitted. Ends with a line feed. `povray_version` is empty when
/// POV-Ray was not used.
std::string validations_to_json(const std::vector<Validation>& validations,
                                const std::string& povray_version);

/// For junit_xml(): an expected refusal counts as skipped.
std::vector<JUnitCase> junit_cases(const std::vector<Validation>& validations);

/// The entry for the report.
ReportEntry report_entry(const Validation& validation);

/// The headings of the report's table.
std::vector<std::string> validation_columns(const std::string& other);

/// The report, still without entries.
Report validation_report(const reference::PovRay& povray, const std::string& lancer_version);

}  // namespace lancer::judge
