// Libraries for pictures run in a process of their own, where a file that breaks them breaks
// nothing else.
//
// The process is this program, started again when the first such picture is met (picture_server.h).
// It makes a copy of itself for each picture; that copy may read one descriptor and write another,
// open nothing, and use as much memory and time as PictureLimits allow.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace lancer::io {

/// What the work on one picture may cost.
struct PictureLimits {
    std::uint64_t memory = 4096;  ///< MiB, for the library and again for the pixels
    std::uint64_t seconds = 60;   ///< of a processor, plus one for each MiB that is given to it
};

/// From now on, for all threads.
void set_picture_limits(const PictureLimits& limits);

/// The program to start; without this call it is the one called `lancer` in the folder of the
/// running one, as it stands for tests. The command line names itself.
void set_picture_program(const std::filesystem::path& program);

enum class PictureTask : std::uint32_t { read = 1, write };

/// Has the picture process read `input`, a file, or write `input`, a picture of a SharedSink, into
/// `output`, a SharedMemory that is empty. `format` is openexr, hdr, tiff or jpeg. Returns why that
/// failed, whatever happened there; empty: `output` holds what read_shared() reads. Any thread.
std::string work_on_picture(PictureTask task, const std::string& format, int input, int output);

}  // namespace lancer::io
