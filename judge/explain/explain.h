// Judges two pictures of one scene: which differences are unavoidable, and which are errors.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "judge/explain/edges.h"
#include "judge/explain/nearby_edge.h"
#include "judge/explain/probe_function.h"
#include "judge/explain/shift.h"
#include "model/image.h"

namespace lancer::judge {

/// What two programs must achieve to count as in agreement, in linear light. A scene may replace
/// single values in its .expect file (validate/expect.h).
struct Thresholds {
    /// A pixel that differs by more must be explained.
    double interior = 1e-4;
    std::size_t unexplained = 0;  ///< pixels over `interior` that may remain without an explanation
    /// At least `tight_share` of the pixels without an edge differ by no more than `tight`. Half a
    /// step of a 16-bit picture is 7.6e-6.
    double tight = 2e-5;
    double tight_share = 0.999;
    /// An edge explains a pixel when it passes the pixel's centre within this many pixels.
    double radius = 0.01;
    /// At most this share of the edge pixels may be explained ...
    double explained_share = 0.04;
    /// ... and at most this share by an edge further away than rounding can move it.
    double displaced_share = 0.001;
    double rounding = 1e-4;  ///< pixels
    /// How far, in pixels, the limited precision of POV-Ray's solver moves the target of a ray.
    double digits = 1e-7;
    /// At most this share of all pixels may be outliers, and at most as many are examined.
    double outlier_share = 1e-4;
    /// The pictures may be shifted against each other by less than this many pixels.
    double shift = 1e-3;
};

enum class PixelClass : std::uint8_t {
    agrees,      ///< within Thresholds::interior
    silhouette,  ///< explained, by the kind of edge
    shadow,
    texture,
    secondary,
    steep,        ///< explained: the last digits of the ray decide its colour
    coincident,   ///< coincident faces: when they are told apart, the other program has our value
    outlier,      ///< the other picture has our value around the pixel's centre
    known,        ///< the other program differs by a rule of its own
    unexplained,  ///< an error, or not examined because the rays were used up
};
inline constexpr std::size_t pixel_classes = 10;
std::string class_name(PixelClass pixel_class);
/// Whether the class depends on what POV-Ray or its rules give beside its picture.
bool needs_povray(PixelClass pixel_class);

/// A pixel that differs by more than `interior`.
struct DifferentPixel {
    int x = 0;
    int y = 0;
    PixelClass pixel_class = PixelClass::unexplained;
    double difference = 0;
    Color ours{0, 0, 0};
    Color theirs{0, 0, 0};
    Offset offset;  ///< from the centre to the edge that explains it
    bool took_povray =
        false;  ///< its class took more of POV-Ray, or of its rules, than its picture
};

struct Judgement {
    bool pass = false;
    std::vector<std::string>
        failures;               ///< one sentence each, with the achieved value and the threshold
    std::string shift_failure;  ///< the one about `picture_shift`; may be empty

    std::size_t pixels = 0;
    std::size_t edge_pixels = 0;
    std::size_t interior_pixels = 0;  ///< neither edges nor explained nor known
    double interior_max = 0;
    double interior_p999 = 0;
    double tight_share = 1;  ///< achieved
    std::size_t counts[pixel_classes] = {};
    std::size_t not_looked_at = 0;  ///< unexplained because the rays were used up
    std::uint64_t rays = 0;         ///< the cost of explaining
    std::size_t explained = 0;
    std::size_t displaced = 0;  ///< explained by an edge further than Thresholds::rounding
    Shift edge_shift;           ///< mean of the explained pixels' offsets
    Shift picture_shift;        ///< from registration of the areas between edges

    std::vector<DifferentPixel> different;  ///< rows from the top
    std::vector<PixelClass> classes;        ///< of every pixel, rows from the top

    std::size_t count(PixelClass c) const { return counts[static_cast<std::size_t>(c)]; }
};

/// The other program's picture of the scene whose coincident faces were told apart in the way of
/// our contact rule.
struct ResolvedPicture {
    Image theirs;
    // As in SecondLook, for the scene whose faces were told apart.
    ProbeFunction by_rules;
    ProbeFunction without;
};

/// Further evidence about a different pixel. All members may be empty.
struct SecondLook {
    // The picture from a second recursion, not our renderer's own.
    ProbeFunction by_rules;  ///< with the other program's rules: gives the other program's values
    ProbeFunction without;   ///< without these rules: gives our values
    /// The other program's picture of 3 x 3 points, `pitch` pixels apart, around the centre of
    /// pixel (x, y). Costs a run of that program.
    std::function<Image(int x, int y, double pitch)> around{};
    /// Empty when no faces coincide. Costs a run of that program at the first call.
    std::function<const ResolvedPicture&()> resolved{};
};

/// Judges `theirs` by `ours`. Both are finite, have the same size and three channels; `probe` gives
/// `ours` at the pixels' centres. A pixel is a known difference, reported by number, when the
/// second recursion gives the other program's value by that program's rules, and our value without
/// them. This shows that the rules cause the difference, and not an error of our recursion.
///
/// Explanations could excuse anything, so they are bounded. Rounding moves an edge by 10^-12 pixel
/// or, where POV-Ray uses single precision, by 10^-5; then hardly any pixel lies between the two
/// edges. A camera that is off by 0.005 pixel changes 0.5 % of the pixels at vertical edges, all to
/// the same side: the count of displaced edges and the mean of the offsets reveal it. On smooth
/// shading, it causes a difference along the gradient, which no edge explains and registration
/// finds.
///
/// Where faces coincide, the other program has no rule which of them it finds. It renders once more
/// with the faces slightly apart. It must then have our value in the pixel, or what its rules make
/// of our value: so our picture is not the wrong one.
///
/// If nothing explains a pixel, the other program renders the points around its centre. When the
/// mean of opposite points equals our value, in at least two directions, its own picture
/// contradicts the pixel: the pixel is an outlier, as when a solver loses a root.
///
/// Explaining a pixel takes thousands of probes. Once they have cost `most_rays`, the remaining
/// pixels count as unexplained.
Judgement judge_pictures(const Image& ours, const Image& theirs, const ProbeFunction& probe,
                         const Thresholds& thresholds, const SecondLook& second = {},
                         std::uint64_t most_rays = std::numeric_limits<std::uint64_t>::max());

}  // namespace lancer::judge
