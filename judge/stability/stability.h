// How far a scene can be changed before its picture changes: its safe window.
//
// A picture should not depend on the unit of length, on where the origin is, on what the axes are
// called, on how far the camera stands when its angle shrinks alike. In floating point it does, at
// the latest where the scene's own numbers lose their digits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "model/image.h"
#include "model/scene.h"
#include "reference/pov/export.h"
#include "reference/povray/runner.h"

namespace lancer::judge {

enum class Change {
    scale,     ///< all lengths times 10^k
    twos,      ///< all lengths times 2^k, which rounds nothing: the same bytes are asked for
    shift,     ///< 10^k added to x, y and z
    distance,  ///< the camera 10^k as far away, showing as much; judged by `extended` at each k
    axes,      ///< x, y, z renamed y, z, x, once and twice
    extended,  ///< the scene as it is, in 64 instead of 53 bits
};
inline constexpr Change all_changes[] = {Change::scale,    Change::twos, Change::shift,
                                         Change::distance, Change::axes, Change::extended};

/// `scale` and so on: the word of the command line and of the JSON.
const char* name_of(Change change);
/// Of the factor, or of the length for `shift`: 2 or 10; 0 for those that know no more or less.
int base_of(Change change);

/// One change, and how far it is tried. `axes` and `extended` know no more or less.
struct Trial {
    Change change = Change::scale;
    int low =
        0;  ///< least exponent: <= 0 for `scale` and `twos`, 0 for `distance`, any for `shift`
    int high = 0;           ///< greatest exponent, >= low; for all but `shift` >= 0
    std::vector<int> also;  ///< exponents to be looked at whatever the search thinks

    /// The exponent that leaves the scene as it is; for `shift` the one before the first.
    int origin() const { return change == Change::shift ? low - 1 : 0; }
};

struct Sample {
    int exponent = 0;           ///< of the change's base; of `axes` how many times
    std::size_t wrong = 0;      ///< pixels off by more than StabilityOptions::fail in a channel
    std::size_t different = 0;  ///< pixels with another bit anywhere
    double most = 0;            ///< largest difference of a channel
    std::string failure;        ///< why there is no picture; then all pixels are wrong
    bool right = false;
};

/// What was found out about one change.
struct Window {
    Trial trial;
    std::vector<Sample> samples;  ///< by exponent, each once; the unchanged scene is not among them
    /// The window's ends: from the origin to here every sample is right. The origin itself when
    /// already the first step is wrong. Unused for `axes` and `extended`.
    int lowest = 0;
    int highest = 0;
    bool cut_short = false;  ///< no time was left for the rest

    /// Whether `low` and `high` (or the origin) were looked at and all between them is right.
    bool holds(int low, int high) const;
    /// Whether every sample is right and none is missing.
    bool holds() const;
};

struct StabilityOptions {
    /// A pixel is wrong when a channel, clipped to 0..1, is off by more than this (linear light).
    double fail = 1.0 / 255;
    /// A picture is right when no more than this percentage of its pixels are wrong.
    double fail_percent = 0;
    /// Look at every exponent, also beyond the window, instead of searching for its ends.
    bool every = false;
};

/// Renders the scene's view in this number type. Throws SceneError.
using PreciseRenderer = std::function<Image(const Scene& scene, Precision precision)>;

/// Lancer's renderer, for this view of each scene.
PreciseRenderer renderer_of(const reference::ExportView& view);

/// Where samples are kept that were taken already.
struct SampleCache {
    std::string folder;  ///< empty: nowhere
    /// All that decides a sample beside its change: the scene, the view, the options, the program
    /// itself. Hashed.
    std::string content;
    bool grows = false;  ///< new samples are kept
};

class StabilityTest {
  public:
    /// \param may_go_on  asked before every picture; once false, what is open stays open
    StabilityTest(const Scene& scene, PreciseRenderer renderer, const StabilityOptions& options,
                  std::function<bool()> may_go_on, SampleCache cache = {});

    /// Throws SceneError when the scene as it is cannot be rendered. Tries one change, with few
    /// pictures: exponents 1, 2, 4, 8 … until one is wrong, then halves. What is wrong only between
    /// exponents that were right is not found; `every` looks at all.
    Window run(const Trial& trial);

  private:
    /// Looks at one exponent, unless it was looked at; false when no time is left.
    bool look(Window& window, int exponent);
    Sample sample_of(Change change, int exponent);
    bool look_for_end(Window& window, int limit);

    const Scene& scene_;
    PreciseRenderer render_;
    StabilityOptions options_;
    std::function<bool()> may_go_on_;
    SampleCache cache_;
    std::optional<Image> unchanged_;
};

/// The scene with all lengths times 10^k, and so on for the other changes.
Scene changed(const Scene& scene, Change change, int exponent);

/// How far each change is tried when nobody says. `shift` begins at the picture's own size: the
/// first camera's distance from what it looks at.
Trial default_trial(const Scene& scene, std::uint32_t camera, Change change);

/// 10^k to the last bit.
double power_of_ten(int exponent);

/// `wrong` and so on of one picture against another of the same size.
Sample compare_to(const Image& reference, const Image& image, int exponent,
                  const StabilityOptions& options);

/// POV-Ray's pictures of the scene's lengths times 10^k, against its own picture at the size that
/// the exporter chooses for it, for exponents around that.
struct PovRayWindow {
    std::vector<Sample> samples;
    int best = 0;  ///< exponent that the exporter chooses
    int lowest = 0;
    int highest = 0;
    std::string version;
    std::string failure;  ///< why POV-Ray was not asked; then the rest is empty
};
PovRayWindow povray_window(const Scene& scene, const reference::ExportView& view,
                           const reference::PovRay& povray,
                           const reference::PovOptions& pov_options,
                           const StabilityOptions& options);

}  // namespace lancer::judge
