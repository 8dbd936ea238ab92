// How another renderer's picture is to be read, and where its rays are.
#pragma once

#include "model/io/image_file.h"

namespace lancer::judge {

/// The curve that stands between the file's numbers and light.
struct Encoding {
    enum class Kind {
        automatic,  ///< what the file says of itself, see docs/files.md
        linear,     ///< the numbers are light
        srgb,
        gamma,  ///< light is the number to the power of `exponent`
    };
    Kind kind = Kind::automatic;
    double exponent = 2.2;  ///< > 0
};

struct Reading {
    Encoding encoding;
    /// The picture holds light times this; > 0.
    double exposure = 1;
    /// Where in a pixel its ray goes through, from the pixel's top left corner, 0..1.
    double center_x = 0.5;
    double center_y = 0.5;
};

/// What a file holds, in linear light, three channels.
struct ForeignPicture {
    Image light;
    /// The same with every number half a step higher, but for 1: what is meant by a program that
    /// rounds down. Empty where the numbers are not those of 16 bits.
    Image raised;
};

/// Reads the picture for a judgement that lets values differ by `tolerance`. Throws FileError when
/// it cannot be read, has alpha, or holds steps that are too coarse for such a judgement (8 bits,
/// half floats).
ForeignPicture read_foreign_picture(const std::string& path, const Encoding& encoding,
                                    double tolerance);

/// Whether the numbers of the file are `ours` rounded down, and not to the nearest. Told by pixels
/// that agree, where there are enough.
bool is_rounded_down(const Image& ours, const ForeignPicture& picture);

}  // namespace lancer::judge
