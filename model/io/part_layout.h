// The file layout of a part: an EXR with one EXR part for each of its strips, uncompressed, so that
// the place of every row is known before the first is drawn.
//
// In addition to the 32-bit floats of an EXR, the colours have channels `exact.R`, `exact.G` and
// `exact.B` of integers, which hold the remainder of a double after rounding to float. So a PNG
// joined from parts is rounded once, like that of the whole picture.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/image.h"
#include "model/io/origin.h"

namespace lancer::io {

/// A range of rows of the picture, counted from its top.
struct Strip {
    int first = 0;
    int rows = 0;
};

/// The header of a part.
struct PartHead {
    int number = 1;  ///< from 1
    int count = 1;   ///< of all parts
    int width = 0;   ///< of the whole picture
    int height = 0;
    std::vector<std::string> extra_names;  ///< as in Image; without blanks
    Origin origin;
    /// Data for `join` beside the pixels, known when the first row is written; without line feeds.
    std::string note{};

    int channels() const { return 3 + static_cast<int>(extra_names.size()); }
};

/// The strips of a part. Strips are dealt to the parts in turn, because work is seldom spread
/// evenly over a picture. Each part gets at least four if the picture has enough rows.
std::vector<Strip> strips_of(const PartHead& head);

/// The bytes of a pixel in a part: three exact values, and the floats of all channels.
std::size_t pixel_bytes(const PartHead& head);
/// The bytes before each row: the number of its strip, the row, and its length.
std::string row_head(const PartHead& head, int strip, int row);

/// The text with which the digest of a part begins, before its rows.
std::string sealed_text(const PartHead& head);
/// All bytes before the first row. `seal` is the digest.
std::string file_head(const PartHead& head, const std::string& seal);

/// The content of file_head(), and the digest; `begin` is the file's first most_head_text bytes.
/// Nothing when it is not a part. This is no proof: the rest of the head must be compared.
struct ToldHead {
    PartHead head;
    std::string seal;
};
std::optional<ToldHead> told_head(std::string_view begin);
inline constexpr std::size_t most_head_text = 1 << 16;

/// Encode one row of doubles as in Image, and decode it.
void encode_row(const PartHead& head, const double* pixels, std::string& bytes);
void decode_row(const PartHead& head, const std::string& bytes, double* pixels);

}  // namespace lancer::io
