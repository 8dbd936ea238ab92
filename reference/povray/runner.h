// Finds POV-Ray, asks for its version, runs it, and reads its pictures.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "model/image.h"
#include "reference/pov/export.h"

namespace lancer::reference {

/// A POV-Ray 3.7 on this machine.
struct PovRay {
    std::string program;  ///< path
    std::string version;  ///< as it reports itself, e.g. "3.7.0.10.unofficial"
};

/// The program that LANCER_POVRAY names, otherwise the first `povray` in PATH. Throws FileError
/// when there is none, when it does not answer within 20 s, or when it is not POV-Ray 3.7.
PovRay find_povray();

/// One picture to make.
struct PovJob {
    std::string name = "scene";  ///< names the job in messages
    std::string text;            ///< of the `.pov`
    std::vector<Asset> assets;
    int width = 640;
    int height = 480;
};

struct PovOptions {
    double time_limit = 120;  ///< seconds for one picture; then POV-Ray is killed
    int threads = 1;          ///< of one POV-Ray; the picture does not depend on it
    /// The folder of the cache; empty: none. See cache_folder().
    std::string cache;
};

struct PovPicture {
    Image image;         ///< linear light; POV-Ray clips it to 0..1 in steps of 1/65535
    double seconds = 0;  ///< that POV-Ray took, when it made the picture
    bool from_cache = false;
    std::string command;                ///< the command, as one would type it
    std::vector<std::string> warnings;  ///< POV-Ray's own lines; empty when from the cache
};

/// The arguments of POV-Ray for a picture of this size: 16 bits, linear, no antialiasing, no
/// display.
std::vector<std::string> povray_arguments(int width, int height, int threads);

/// Runs POV-Ray in a new temporary folder, or takes the picture from the cache. Throws FileError,
/// with POV-Ray's own error messages, when it fails, exceeds the time limit, or writes no such
/// picture.
PovPicture run_povray(const PovRay& povray, const PovJob& job, const PovOptions& options = {});

/// The picture, or the reason why there is none.
struct PovOutcome {
    std::optional<PovPicture> picture;
    std::string failure;
};

/// Runs several jobs, `parallel` of them at once; 0: twice as many as there are cores, because
/// POV-Ray sleeps for half a second when it starts. Results are in the order of the jobs.
/// `on_done`, if any, is called with the index of each finished job, one call at a time.
std::vector<PovOutcome> run_povray_jobs(const PovRay& povray, const std::vector<PovJob>& jobs,
                                        const PovOptions& options = {}, int parallel = 0,
                                        const std::function<void(std::size_t)>& on_done = {});

/// $LANCER_CACHE, otherwise $XDG_CACHE_HOME/lancer, otherwise ~/.cache/lancer; empty when none is
/// known.
std::string cache_folder();

}  // namespace lancer::reference
