// Runs picture libraries in a separate process, so that a file that crashes them harms nothing
// else.
//
// The process is this program, started again for the first such picture (picture_server.h). It
// forks for each picture. The forked process may read one descriptor and write another, cannot open
// files, and is limited in memory and time by PictureLimits.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace lancer::io {

/// Limits on the work on one picture.
struct PictureLimits {
    std::uint64_t memory = 4096;  ///< MiB, for the library and again for the pixels
    std::uint64_t seconds = 60;   ///< of processor time, plus one for each MiB of input
};

/// Sets the limits for all threads from now on.
void set_picture_limits(const PictureLimits& limits);

/// Sets the program to start. Without this call it is the file `lancer` in the folder of the
/// running program, which suits tests. The command line program sets itself.
void set_picture_program(const std::filesystem::path& program);

enum class PictureTask : std::uint32_t { read = 1, write };

/// Has the picture process read `input`, a file, or write `input`, a picture of a SharedSink, into
/// `output`, an empty SharedMemory. `format` is openexr, hdr, tiff or jpeg. Returns the reason of
/// any failure; empty: read_shared() can read `output`. Thread-safe.
std::string work_on_picture(PictureTask task, const std::string& format, int input, int output);

}  // namespace lancer::io
