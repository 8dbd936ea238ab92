#include "judge/report/junit.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "judge/report/html.h"

namespace lancer::judge {

namespace {

/// XML 1.0 allows no control characters but tab and line ends, not even as entities.
std::string xml(std::string text) {
    for (char& c : text)
        if (static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n' && c != '\r') c = '?';
    return escaped(text);
}

const char* element_of(JUnitCase::Outcome outcome) {
    switch (outcome) {
        case JUnitCase::Outcome::passed:
            return "";
        case JUnitCase::Outcome::failed:
            return "failure";
        case JUnitCase::Outcome::error:
            return "error";
        case JUnitCase::Outcome::skipped:
            return "skipped";
    }
    return "";
}

}  // namespace

std::string junit_xml(const std::string& suite, const std::vector<JUnitCase>& cases) {
    using Outcome = JUnitCase::Outcome;
    const auto count = [&](Outcome outcome) {
        return std::count_if(cases.begin(), cases.end(),
                             [&](const JUnitCase& c) { return c.outcome == outcome; });
    };
    double seconds = 0;
    for (const JUnitCase& c : cases) seconds += c.seconds;
    const std::string counts = fmt::format(
        "name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\" time=\"{:.3f}\"",
        xml(suite), cases.size(), count(Outcome::failed), count(Outcome::error),
        count(Outcome::skipped), seconds);
    std::string text = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n<testsuite {}>\n", counts);
    for (const JUnitCase& c : cases) {
        text += fmt::format("  <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\"", xml(suite),
                            xml(c.name), c.seconds);
        if (c.outcome == Outcome::passed) {
            text += "/>\n";
            continue;
        }
        text += fmt::format(">\n    <{0} message=\"{1}\">{2}</{0}>\n  </testcase>\n",
                            element_of(c.outcome), c.reasons.empty() ? "" : xml(c.reasons.front()),
                            xml(fmt::format("{}", fmt::join(c.reasons, "\n"))));
    }
    return text + "</testsuite>\n</testsuites>\n";
}

}  // namespace lancer::judge
