// Results as JUnit XML, which build servers read.
#pragma once

#include <string>
#include <vector>

namespace lancer::judge {

struct JUnitCase {
    enum class Outcome { passed, failed, error, skipped };
    std::string name;
    double seconds = 0;
    Outcome outcome = Outcome::passed;
    std::vector<std::string> reasons;  ///< one sentence each; the first is the message
};

/// A `testsuites` element with one suite. Ends with a line feed.
std::string junit_xml(const std::string& suite, const std::vector<JUnitCase>& cases);

}  // namespace lancer::judge
