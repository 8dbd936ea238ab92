// Estimates the cost of settings so that a busy machine has little influence.
//
// The rays of a setting are the same in each run, but its seconds are not. So the seconds of all
// settings together determine the cost of a ray in this scene, and a setting's rays determine its
// cost. Its own seconds count only as far as they differ significantly from that.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tracer/render.h"

namespace lancer::judge {

struct TimedSetting {
    /// The properties that make a ray cheaper or more expensive: precision, triangles instead of
    /// exact surfaces and so on. The cost of rays is fitted for the way of the first setting; the
    /// other ways differ by a factor.
    std::string way;
    int max_depth = 0;  ///< of the recursion: threads keep room for as many levels
    RayCounts rays;
    std::vector<double> seconds;  ///< of processor time, one per round; a round runs all settings
};

/// What a picture takes, what each step of the largest depth adds, and each ray. One to a light,
/// which brings no shading, counts half.
struct RaySeconds {
    double picture = 0;
    double depth = 0;
    double ray = 0;

    double of(const TimedSetting& setting) const;
};

struct SteadyCosts {
    RaySeconds fitted;
    std::vector<double> seconds;  ///< one per setting
    /// Half of the 95 % interval for the median of a setting's runs, as a share of it.
    double noise = 0;
};

/// \param settings  at least one, each with at least one run
SteadyCosts steady_costs(std::span<const TimedSetting> settings);

/// The value below which this share of the distribution lies, estimated from a sample. Small and
/// large samples give the same value on average, as far as possible. 0 for an empty sample.
double quantile_of(std::vector<double> values, double share);
/// The median; 0 for an empty sample.
double median_of(std::vector<double> values);

}  // namespace lancer::judge
