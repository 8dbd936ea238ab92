// Finds how far a scene can be changed before its picture changes: its safe window.
//
// A picture should not depend on the unit of length, on the origin, on the names of the axes, or on
// the camera's distance when its angle shrinks with it. In floating point it does, at the latest
// where the scene's own numbers lose their digits.
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
    scale,  ///< all lengths times 10^k
    twos,   ///< all lengths times 2^k, which is exact: the bytes must be the same
    shift,  ///< 10^k added to x, y and z
    /// the camera 10^k times as far away with the same extent; compared with `extended` at each k
    distance,
    axes,      ///< x, y, z renamed y, z, x, once and twice
    extended,  ///< the scene as it is, in 64 instead of 53 bits
};
inline constexpr Change all_changes[] = {Change::scale,    Change::twos, Change::shift,
                                         Change::distance, Change::axes, Change::extended};

/// `scale` and so on: the name on the command line and in JSON.
const char* name_of(Change change);
/// The base of the factor, or of the length for `shift`: 2 or 10. It is 0 for changes that have no
/// exponent.
int base_of(Change change);

/// One change and the range in which it is tried. `axes` and `extended` have no range.
struct Trial {
    Change change = Change::scale;
    int low =
        0;  ///< least exponent: <= 0 for `scale` and `twos`, 0 for `distance`, any for `shift`
    int high = 0;           ///< greatest exponent, >= low; for all but `shift` >= 0
    std::vector<int> also;  ///< exponents to be tried in any case

    /// The exponent that leaves the scene unchanged; for `shift` the one before the first.
    int origin() const { return change == Change::shift ? low - 1 : 0; }
};

struct Sample {
    int exponent = 0;           ///< of the change's base; for `axes` the number of renamings
    std::size_t wrong = 0;      ///< pixels off by more than StabilityOptions::fail in a channel
    std::size_t different = 0;  ///< pixels whose bits differ at all
    double most = 0;            ///< largest difference of a channel
    std::string failure;        ///< why there is no picture; then all pixels are wrong
    bool right = false;
};

/// The result for one change.
struct Window {
    Trial trial;
    std::vector<Sample> samples;  ///< by exponent, each once; the unchanged scene is not among them
    /// The window's ends: every sample from the origin to here is right. Equal to the origin when
    /// the first step is already wrong. Unused for `axes` and `extended`.
    int lowest = 0;
    int highest = 0;
    bool cut_short = false;  ///< no time was left for the rest

    /// Whether `low` and `high` (or the origin) were tried and all samples between them are right.
    bool holds(int low, int high) const;
    /// Whether every sample is right and none is missing.
    bool holds() const;
};

struct StabilityOptions {
    /// A pixel is wrong when the error of a channel, clipped to 0..1, exceeds this (linear light).
    double fail = 1.0 / 255;
    /// A picture is right when at most this percentage of its pixels are wrong.
    double fail_percent = 0;
    /// Try every exponent, even beyond the window, instead of searching for its ends.
    bool every = false;
};

/// Renders the scene's view in this number type. Throws SceneError.
using PreciseRenderer = std::function<Image(const Scene& scene, Precision precision)>;

/// Lancer's renderer, for this view of each scene.
PreciseRenderer renderer_of(const reference::ExportView& view);

/// The cache of samples.
struct SampleCache {
    std::string folder;  ///< empty: nowhere
    /// All that a sample depends on beside its change: the scene, the view, the options, the
    /// program itself. It is hashed.
    std::string content;
    bool grows = false;  ///< new samples are kept
};

class StabilityTest {
  public:
    /// \param may_go_on  called before every picture; after false, the remaining samples are not
    /// taken
    StabilityTest(const Scene& scene, PreciseRenderer renderer, const StabilityOptions& options,
                  std::function<bool()> may_go_on, SampleCache cache = {});

    /// Tries one change with few pictures: exponents 1, 2, 4, 8 … until one is wrong, then bisects.
    /// An error that occurs only between two right exponents is not found; `every` tries all.
    /// Throws SceneError when the unchanged scene cannot be rendered.
    Window run(const Trial& trial);

  private:
    /// Tries one exponent, unless it was tried before; false when no time is left.
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

/// The default range of each change. `shift` begins at the picture's own size: the first camera's
/// distance from its look_at point.
Trial default_trial(const Scene& scene, std::uint32_t camera, Change change);

/// 10^k, correct to the last bit.
double power_of_ten(int exponent);

/// Counts wrong pixels of one picture against another of the same size.
Sample compare_to(const Image& reference, const Image& image, int exponent,
                  const StabilityOptions& options);

/// POV-Ray's pictures of the scene with lengths times 10^k, compared with its own picture at the
/// size that the exporter chooses, for exponents around that size.
struct PovRayWindow {
    std::vector<Sample> samples;
    int best = 0;  ///< exponent that the exporter chooses
    int lowest = 0;
    int highest = 0;
    std::string version;
    std::string failure;  ///< why POV-Ray did not run; the rest is then empty
};
PovRayWindow povray_window(const Scene& scene, const reference::ExportView& view,
                           const reference::PovRay& povray,
                           const reference::PovOptions& pov_options,
                           const StabilityOptions& options);

}  // namespace lancer::judge
