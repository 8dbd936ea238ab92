// Compares two folders of pictures, paired by name, whatever programs made them.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "judge/report/junit.h"
#include "judge/report/report.h"
#include "reference/compare/compare.h"

namespace lancer::judge {

/// The measures of one pair, for JSON.
struct PairResult {
    std::string name;
    Verdict verdict = Verdict::failed;
    std::string reason;  ///< empty when it agrees
    std::optional<reference::Comparison> measures;
};

struct FolderComparison {
    Report report;
    std::vector<PairResult> pairs;  ///< by name
    bool pass = false;
    std::size_t unreadable = 0;  ///< pictures that could not be read
};

/// Names of the pictures (png, exr, hdr, tif, tiff, jpg, jpeg, ppm) below `folder`, relative to it.
/// Throws FileError when the folder cannot be listed.
std::set<std::string> pictures_in(const std::string& folder);

/// The mask of a pair of pictures, by its name; may be empty. It may throw FileError.
using MaskOf = std::function<reference::PixelMask(const std::string& name)>;

/// Compares each picture of `a` (png, exr, hdr, tif, tiff, jpg, jpeg, ppm) with the file of the
/// same name in `b`, including sub-folders. A picture that only one folder has fails, and so does
/// an unreadable one. `on_pair`, if any, receives each entry with its verdict. Throws FileError
/// when a folder cannot be listed or holds no picture at all.
FolderComparison compare_folders(const std::string& a, const std::string& b,
                                 const reference::CompareOptions& options,
                                 const std::function<void(const ReportEntry&)>& on_pair = {},
                                 const MaskOf& mask_of = {});

/// {"verdict", "pairs": [{"name", "verdict", "reason", then the measures as `compare` gives
/// them}]}. Ends with a line feed.
std::string to_json(const FolderComparison& comparison, const reference::CompareOptions& options);
std::vector<JUnitCase> junit_cases(const FolderComparison& comparison);

/// The report's entry for one pair of pictures.
ReportEntry pair_entry(const std::string& name, const Image& a, const Image& b,
                       const reference::CompareOptions& options);

}  // namespace lancer::judge
