// Opens a picture file for the decoder that its first bytes require.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "model/io/stored_image.h"

namespace lancer::io {

/// An open picture: the file itself, or the content of one that cannot be read twice (a pipe,
/// standard input). Throws FileError, whose message names `path`.
class PictureInput {
  public:
    explicit PictureInput(const std::string& path);
    ~PictureInput();
    PictureInput(const PictureInput&) = delete;
    PictureInput& operator=(const PictureInput&) = delete;

    /// The first bytes: enough to determine the format.
    std::string_view start() const { return file_ < 0 ? std::string_view(bytes_) : start_; }
    /// All bytes.
    std::string bytes() const;
    /// A descriptor of all bytes, for another process.
    int descriptor();

  private:
    std::string path_;
    int file_ = -1;
    std::string start_;
    std::string bytes_;  ///< when there is no file to read again
    std::optional<SharedMemory> memory_;
};

}  // namespace lancer::io
