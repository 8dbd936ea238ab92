// How to read another renderer's picture, and where in a pixel its rays go.
#pragma once

#include "model/io/image_file.h"

namespace lancer::judge {

/// The transfer curve between the file's values and light.
struct Encoding {
    enum class Kind {
        automatic,  ///< the file's own declaration, see docs/files.md
        linear,     ///< the numbers are light
        srgb,
        gamma,  ///< light is the number to the power of `exponent`
    };
    Kind kind = Kind::automatic;
    double exponent = 2.2;  ///< > 0
};

struct Reading {
    Encoding encoding;
    /// The picture holds light multiplied by this; > 0.
    double exposure = 1;
    /// Where in a pixel the ray goes, from the pixel's top left corner, 0..1.
    double center_x = 0.5;
    double center_y = 0.5;
};

/// The content of a file in linear light, three channels.
struct ForeignPicture {
    Image light;
    /// The same with every value except 0 and 1 half a step higher: the best estimate if the
    /// program rounds down. Empty when the file's values are not those of 16 bits.
    Image raised;
};

/// Reads the picture for a judgement with this tolerance. Throws FileError when it cannot be read,
/// has an alpha channel, or has steps too coarse for the tolerance (8 bits, half floats).
ForeignPicture read_foreign_picture(const std::string& path, const Encoding& encoding,
                                    double tolerance);

/// Whether the values of the file are `ours` rounded down and not to the nearest. Uses pixels that
/// agree, if there are enough.
bool is_rounded_down(const Image& ours, const ForeignPicture& picture);

}  // namespace lancer::judge
