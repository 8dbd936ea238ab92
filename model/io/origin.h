// The origin of a picture, as its file records it: two files with the same origin show the same
// picture.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "model/io/image_file.h"

namespace lancer::io {

/// All that the pixels depend on. The members contain no line feed.
struct Origin {
    std::string scene;    ///< digest of what the evaluated scene shows
    std::string build;    ///< digest of the program's sources and of how they were compiled
    std::string options;  ///< for people too, as in "size 640x480, samples 2"

    bool operator==(const Origin&) const = default;
};

/// Three lines of text.
std::string to_text(const Origin& origin);
/// The origin that to_text() wrote; nothing when the text has another form.
std::optional<Origin> origin_of_text(std::string_view text);

/// Names the first difference of two origins, for example "another scene". Empty when they are
/// equal.
std::string difference(const Origin& there, const Origin& wanted);

/// The options with which a picture of this origin is encoded: an EXR has the origin as a note.
ImageWriteOptions options_with_origin(ImageWriteOptions options, const std::string& path,
                                      const Origin& origin);
/// The encoded PNG or EXR with its origin and a digest of all its bytes inside.
std::string with_origin(std::string bytes, const Origin& origin);

/// write_image() with both.
void write_image(const std::string& path, const Image& image, ImageWriteOptions options,
                 const Origin& origin);

/// The origin of a PNG or EXR that the function above wrote. Nothing when there is none, or when
/// any bit of the file has changed since.
std::optional<Origin> origin_of_picture(std::string bytes);

}  // namespace lancer::io
