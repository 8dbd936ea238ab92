// A report with pictures side by side and the evidence, in one file that any browser can open
// without a network.
#pragma once

#include <string>
#include <vector>

#include "judge/report/exact_values.h"
#include "model/image.h"
#include "model/math.h"

namespace lancer::judge {

/// A picture as the report shows it: 8 bits, perhaps smaller than the original.
struct Preview {
    std::string png;  ///< empty: there is no picture
    int width = 0;    ///< of the original, in pixels
    int height = 0;
};

/// `image` (linear light, 1, 3 or 4 channels) as a preview, halved until it has at most
/// `most_bytes`.
Preview preview_of(const Image& image, std::size_t most_bytes = 400'000);

/// Halves a preview until it fits, but not below a width of 32 pixels.
void shrink(Preview& preview, std::size_t most_bytes);

/// A value that was achieved, and its requirement.
struct Measure {
    std::string name;
    std::string achieved;
    std::string threshold;  ///< empty: there is no requirement
    bool ok = true;
};

/// A pixel that the report points at.
struct Marker {
    int x = 0;
    int y = 0;
    std::string kind;  ///< "unexplained", "silhouette", ...: decides its colour
    std::string text;  ///< shown under the pointer
    double difference = 0;
    Color left{0, 0, 0};
    Color right{0, 0, 0};
};

/// Sorts markers by importance: unexplained pixels first, then by decreasing difference.
void sort_markers(std::vector<Marker>& markers);

/// A file beside the page.
struct ReportFile {
    std::string name;  ///< without folders
    std::string label;
    std::string bytes;
};

/// A label and its text; a text of several lines keeps its line breaks.
struct Note {
    std::string label;
    std::string text;
};

/// The verdict on one pair, worst first.
enum class Verdict {
    failed,  ///< one of the pictures could not be made or read
    differs,
    refused,  ///< there is no second picture, as expected
    agrees,
};

struct ReportEntry {
    std::string name;
    Verdict verdict = Verdict::failed;
    std::string summary;               ///< one line below the verdict; may be empty
    std::vector<std::string> reasons;  ///< why it does not agree, one sentence each
    Preview left;
    Preview right;
    Preview heat;             ///< heat_map() without its scale
    ExactValues left_values;  ///< for the loupe; may be empty
    ExactValues right_values;
    std::vector<double> differences;  ///< per pixel, for the histogram; may be empty
    std::vector<std::string> cells;   ///< of its line in the table at the top, see Report::columns
    std::vector<Measure> measures;
    std::vector<Marker> markers;
    std::vector<Note> notes;     ///< always shown: known differences, approximations
    std::vector<Note> evidence;  ///< shown on request: commands, versions, sizes
    std::vector<ReportFile> files;
    double left_seconds = 0;  ///< 0: not measured
    double right_seconds = 0;
    /// Within a verdict, larger values come first.
    double urgency = 0;
};

struct Report {
    std::string title;
    std::string left_name;   ///< "Lancer"
    std::string right_name;  ///< "POV-Ray"
    /// Headings of the table at the top, after name and verdict.
    std::vector<std::string> columns;
    std::vector<Note> about;              ///< colour pipelines, versions, the rules of judgement
    std::vector<double> histogram_marks;  ///< thresholds to draw into the histograms
    std::vector<ReportEntry> entries;     ///< in any order
};

/// The whole page. Entries are sorted by urgency.
std::string to_html(const Report& report);

/// Drops the largest exact values, which may take half of the page. Then makes the largest previews
/// coarser until all take no more than `most_bytes` of the page.
void fit(Report& report, std::size_t most_bytes);

/// The limit on the pictures of a written report. With its text, the report stays below 10 MB.
inline constexpr std::size_t report_bytes = 8'500'000;

/// Writes to_html() to `folder`/index.html and the entries' files beside it. Creates the folder
/// when it is missing, and limits the previews to report_bytes. Throws FileError.
void write_report(Report report, const std::string& folder);

}  // namespace lancer::judge
