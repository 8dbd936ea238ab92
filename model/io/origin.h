// What a picture was made from, as its file tells it: two files of one origin show the same
// picture.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "model/io/image_file.h"

namespace lancer::io {

/// All that decides the pixels. The members hold no line feed.
struct Origin {
    std::string scene;    ///< digest of what the evaluated scene shows
    std::string build;    ///< digest of the program's sources and of how they were compiled
    std::string options;  ///< for people too, as in "size 640x480, samples 2"

    bool operator==(const Origin&) const = default;
};

/// Three lines.
std::string to_text(const Origin& origin);
/// The origin that to_text() told; nothing when it did not.
std::optional<Origin> origin_of_text(std::string_view text);

/// How the first that differs of what two pictures were made from is told: "another scene", say.
/// Empty for equal ones.
std::string difference(const Origin& there, const Origin& wanted);

/// write_image() for a PNG or EXR, with its origin and a digest of all its bytes inside.
void write_image(const std::string& path, const Image& image, ImageWriteOptions options,
                 const Origin& origin);

/// The origin of a PNG or EXR that the function above wrote; nothing when there is none, or when
/// one bit of the file has changed since.
std::optional<Origin> origin_of_picture(std::string bytes);

}  // namespace lancer::io
