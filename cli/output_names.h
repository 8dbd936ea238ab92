// What the pictures are called.
#pragma once

#include <cstdint>
#include <string>

#include "model/io/image_file.h"

namespace lancer::cli {

/// Where the picture of `scene` goes when nobody says: its name with .png, in the current folder; a
/// preview's with -preview.png, so that it does not replace the picture.
std::string default_output(const std::string& scene, bool is_preview = false);

/// Where a part of the picture goes when nobody says: `NAME-part-3-of-12.exr`.
std::string default_part(const std::string& scene, int number, int count);

/// `.png` of `a/B.PNG`: the ending of a file's name in small letters, with its dot.
std::string ending_of(const std::string& path);

/// Throws UsageError when no picture, or none with these options, can have this name, and FileError
/// when it is a folder.
void check_picture_name(const std::string& output, const io::ImageWriteOptions& options, bool aov);

/// The names of an animation's pictures, from a pattern with one %d: `out-%d.png`, or
/// `out-%04d.png` for at least four digits with zeros before, `out-%4d.png` with blanks; %% stands
/// for a percent sign. A pattern without %d gets `-%04d` before its ending. The pattern never
/// reaches printf.
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
