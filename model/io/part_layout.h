// How a part of a picture stands in its file: an EXR with one part for each of its strips, without
// compression, so that every row has its place before the first is drawn.
//
// Beside the 32-bit floats of an EXR the colours have channels `exact.R`, `exact.G` and `exact.B`
// of whole numbers, which hold what a double has beyond a float: a PNG that parts are joined to is
// rounded once, as that of the whole picture is.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/image.h"
#include "model/io/origin.h"

namespace lancer::io {

/// Rows of the picture, from its top.
struct Strip {
    int first = 0;
    int rows = 0;
};

/// What a part says of itself.
struct PartHead {
    int number = 1;  ///< from 1
    int count = 1;   ///< of all parts
    int width = 0;   ///< of the whole picture
    int height = 0;
    std::vector<std::string> extra_names;  ///< as in Image; without blanks
    Origin origin;
    /// What `join` needs beside the pixels, known when the first row is written; no line feed.
    std::string note{};

    int channels() const { return 3 + static_cast<int>(extra_names.size()); }
};

/// The strips of a part, which are dealt to the parts in turn: work is seldom spread evenly over a
/// picture. Four and more for each part where the picture has as many rows.
std::vector<Strip> strips_of(const PartHead& head);

/// A pixel's bytes in a part: three exact values, and the others as floats.
std::size_t pixel_bytes(const PartHead& head);
/// What stands before each row: the number of its strip, the row, and its length.
std::string row_head(const PartHead& head, int strip, int row);

/// What the digest of a part begins with, before its rows.
std::string sealed_text(const PartHead& head);
/// All that stands before the first row. `seal` is the digest.
std::string file_head(const PartHead& head, const std::string& seal);

/// What file_head() tells, and the digest; `begin` is the file's first most_head_text bytes.
/// Nothing when it is not of a part. Not proven: the rest of the head has to be compared.
struct ToldHead {
    PartHead head;
    std::string seal;
};
std::optional<ToldHead> told_head(std::string_view begin);
inline constexpr std::size_t most_head_text = 1 << 16;

/// One row, from doubles as in Image and back.
void encode_row(const PartHead& head, const double* pixels, std::string& bytes);
void decode_row(const PartHead& head, const std::string& bytes, double* pixels);

}  // namespace lancer::io
