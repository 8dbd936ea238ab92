// The file names of pictures.
#pragma once

#include <cstdint>
#include <string>

#include "model/io/image_file.h"

namespace lancer::cli {

/// The default name of the picture of `scene`: in the current folder, with the ending .png. A
/// preview gets -preview.png, so that it does not replace the picture.
std::string default_output(const std::string& scene, bool is_preview = false);

/// The default name of a part: `NAME-part-3-of-12.exr`.
std::string default_part(const std::string& scene, int number, int count);

/// The ending of a file's name in lower case, with its dot: `.png` for `a/B.PNG`.
std::string ending_of(const std::string& path);

/// Throws UsageError when no picture, or none with these options, can have this name, and FileError
/// when the name is a folder.
void check_picture_name(const std::string& output, const io::ImageWriteOptions& options, bool aov);

/// The names of an animation's pictures, from a pattern with one %d: `out-%d.png`, `out-%04d.png`
/// for at least four digits with leading zeros, or `out-%4d.png` with leading blanks; %% is a
/// percent sign. A pattern without %d gets `-%04d` before its ending. The pattern is never passed
/// to printf.
class FrameNames {
  public:
    /// Throws UsageError for any other use of %.
    explicit FrameNames(const std::string& pattern);
    std::string name(std::int64_t frame) const;

  private:
    std::string before_;
    std::string after_;
    char fill_ = '0';
    std::size_t width_ = 0;
};

}  // namespace lancer::cli
