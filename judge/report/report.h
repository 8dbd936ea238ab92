// Pictures side by side, with the evidence, in one file that opens in any browser without a
// network.
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

/// `image` (linear light, 1, 3 or 4 channels) as a preview of at most `most_bytes`: halved until it
/// fits.
Preview preview_of(const Image& image, std::size_t most_bytes = 400'000);

/// Halves a preview until it fits; it is never made less than 32 pixels wide.
void shrink(Preview& preview, std::size_t most_bytes);

/// A number that was achieved, and what it had to be.
struct Measure {
    std::string name;
    std::string achieved;
    std::string threshold;  ///< empty: nothing depends on it
    bool ok = true;
};

/// A pixel worth pointing at.
struct Marker {
    int x = 0;
    int y = 0;
    std::string kind;  ///< "unexplained", "silhouette", ...: decides its colour
    std::string text;  ///< shown when pointed at
    double difference = 0;
    Color left{0, 0, 0};
    Color right{0, 0, 0};
};

/// Puts the first in front that a reader must see: the unexplained, of these the largest.
void sort_markers(std::vector<Marker>& markers);

/// A file that stands beside the page.
struct ReportFile {
    std::string name;  ///< without folders
    std::string label;
    std::string bytes;
};

/// A label and what there is to say; a text of several lines is shown as it stands.
struct Note {
    std::string label;
    std::string text;
};

/// What was found of one pair, worst first.
enum class Verdict {
    failed,  ///< one of the pictures could not be made or read
    differs,
    refused,  ///< there is no second picture, and that was expected
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
    std::vector<Note> notes;     ///< shown at once: known differences, approximations
    std::vector<Note> evidence;  ///< shown when asked for: commands, versions, sizes
    std::vector<ReportFile> files;
    double left_seconds = 0;  ///< 0: not measured
    double right_seconds = 0;
    /// Within a verdict what is larger comes first.
    double urgency = 0;
};

struct Report {
    std::string title;
    std::string left_name;   ///< "Lancer"
    std::string right_name;  ///< "POV-Ray"
    /// Of the table at the top, after name and verdict.
    std::vector<std::string> columns;
    std::vector<Note> about;              ///< colour pipelines, versions, the rules of judgement
    std::vector<double> histogram_marks;  ///< thresholds to draw into the histograms
    std::vector<ReportEntry> entries;     ///< in any order
};

/// The whole page. Entries stand in the order in which they need to be looked at.
std::string to_html(const Report& report);

/// Leaves out the largest of the exact values, which may take half of the page, then makes the
/// largest previews coarser until all takes no more than `most_bytes` of the page.
void fit(Report& report, std::size_t most_bytes);

/// What the pictures of a written report may take: with its text it stays below 10 MB.
inline constexpr std::size_t report_bytes = 8'500'000;

/// Writes to_html() to `folder`/index.html, and the entries' files beside it, making the folder
/// when it is missing; the previews are made to fit report_bytes. Throws FileError.
void write_report(Report report, const std::string& folder);

}  // namespace lancer::judge
