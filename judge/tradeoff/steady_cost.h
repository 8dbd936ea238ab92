// What settings cost, told so that a busy machine changes little of it.
//
// The rays of a setting are the same in each run, its seconds are not. So the seconds of all
// settings together tell what a ray takes in this scene, and a setting's rays tell what it takes.
// Its own seconds have a say as far as they surely differ from that.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tracer/render.h"

namespace lancer::judge {

struct TimedSetting {
    /// What makes a ray cheaper or dearer: digits, triangles in place of true surfaces ... Rays are
    /// fitted to the way of the first setting; other ways are that times a factor.
    std::string way;
    int max_depth = 0;  ///< of the recursion: threads keep room for as many levels
    RayCounts rays;
    std::vector<double> seconds;  ///< of the processor, one a round; a round runs all settings
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
    std::vector<double> seconds;  ///< one a setting
    /// Half an interval of 95 % for the median of a setting's runs, as a share of it.
    double noise = 0;
};

/// \param settings  at least one, each with at least one run
SteadyCosts steady_costs(std::span<const TimedSetting> settings);

/// What a share of all values lie below, by some of them: few runs and many say the same in the
/// mean, as far as few can. 0 of none.
double quantile_of(std::vector<double> values, double share);
/// Half of the values lie below it; 0 of none.
double median_of(std::vector<double> values);

}  // namespace lancer::judge
