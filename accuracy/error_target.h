// A picture whose error is asked for, and told.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "accuracy/audit.h"
#include "accuracy/limits.h"

namespace lancer::accuracy {

struct ErrorGoal {
    double max_error = 0.01;  ///< RMSE over pixels and channels in linear light, > 0
    std::uint64_t seed = 0;
    bool audited = true;  ///< false: no ray beside those of the picture, and no interval
    FixedLimits fixed;
    /// The renderer leaves out more than limits do: shadows, normals, digits ...
    bool leaves_out = false;
    double most_rays_per_pixel = 1024;  ///< on average
};

/// Refused before the picture is made; the message says what can be reached.
struct Unreachable : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct ErrorReport {
    double asked = 0;
    bool audited = false;
    /// Earlier audits say that one that is printed can be relied on. They alone decide it: were
    /// low draws printed and high ones refused, intervals would be too low.
    bool is_told = false;
    ErrorEstimate error;               ///< of the audit that is printed; without one, nothing
    double effective_draws = 0;        ///< of the last audit that decided
    bool rare_light = false;           ///< specks were met that speak of others: nothing is told
    std::vector<PixelShare> dominant;  ///< where that audit found most, or those specks
    double predicted = 0;              ///< RMSE, from the picture's own samples
    TraceLimits limits;                ///< that the picture was made with
    double rays_per_pixel = 0;         ///< through the image plane
    double even_rays_per_pixel = 0;    ///< predicted: as many everywhere for the same error
    RayCounts picture;                 ///< rays that entered the picture
    RayCounts deciding;                ///< rays that chose limits or decided on going on
    RayCounts printed;                 ///< rays of the audit that is printed

    /// No draw found any difference, and the picture's own samples know of none either.
    bool is_flat() const;
    /// Told, and below what was asked; or flat. Without an audit, predicted so.
    bool is_reached() const;
};

struct ErrorPicture {
    Image image;
    ErrorReport report;
    std::vector<double> errors;         ///< standard error per pixel, RMS over channels: a guess
    std::vector<std::uint32_t> counts;  ///< samples per pixel
};

/// The picture with about the fewest rays whose audited interval ends below the goal. Between
/// passes every decision comes from complete data, so the bytes are the same for any number of
/// threads. Audits decide whether to go on, and whether an error can be told; the last, with fresh
/// draws after the last refinement, is taken once and reported, whatever it says. Throws
/// Unreachable, SceneError.
///
/// \param renderer  makes the picture; may be the truth's own
ErrorPicture render_to_error(const Renderer& renderer, const Truth& truth, const View& view,
                             const ErrorGoal& goal, const Progress& progress);

}  // namespace lancer::accuracy
