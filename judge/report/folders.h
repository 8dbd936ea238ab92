// Two folders of pictures, paired by name: whatever made them.
#pragma once

#include <functional>
#include <string>

#include "judge/report/report.h"
#include "reference/compare/compare.h"

namespace lancer::judge {

struct FolderComparison {
    Report report;
    bool pass = false;
    std::size_t unreadable = 0;  ///< pictures that could not be read
};

/// Compares each file of `a` that is named like a picture (png, exr, hdr, tif, tiff, jpg, jpeg,
/// ppm) with the file of the same name in `b`, sub-folders included. A picture that only one folder
/// has fails, and so does one that cannot be read. `on_pair`, if any, is told each name and its
/// verdict. Throws FileError when a folder cannot be listed or holds no picture at all.
FolderComparison compare_folders(const std::string& a, const std::string& b,
                                 const reference::CompareOptions& options,
                                 const std::function<void(const ReportEntry&)>& on_pair = {});

/// The report's entry for one pair of pictures.
ReportEntry pair_entry(const std::string& name, const Image& a, const Image& b,
                       const reference::CompareOptions& options);

}  // namespace lancer::judge
