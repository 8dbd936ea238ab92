// The audits that decide when a picture is refined enough: how many draws each takes, and in
// which pixels. The last of them settles how the printed audit draws.
#pragma once

#include <cstdint>

#include "accuracy/audit.h"
#include "accuracy/prediction.h"

namespace lancer::accuracy {

/// In standard errors of log T, where T is a mean square. A deciding audit must lie so far below
/// the goal that the printed audit will very likely lie below it too.
inline constexpr double deciding_margin = 3;

/// Draws of the first audit.
inline constexpr int first_draws = 400;

/// Draws of the largest audit. In a small picture, more would cost more than more samples.
int most_draws(const PictureSamples& samples);

class DecidingAudits {
  public:
    /// \param max_error  the goal, an RMSE
    DecidingAudits(const Truth& truth, double max_error);

    /// Takes the first audit.
    ErrorEstimate first(const PictureSamples& samples, const Prediction& prediction,
                        RayCounts& rays);

    /// An audit of draws() draws. It stops after half of them if these decide. If too few draws
    /// carry the result, as many again are drawn where these may be enough; otherwise larger audits
    /// follow, drawn by what the smaller ones have found.
    ErrorEstimate judge(const PictureSamples& samples, const Prediction& prediction,
                        RayCounts& rays);

    /// An audit of its own, drawn as the next one that decides would be.
    Audit separate(const PictureSamples& samples, const Prediction& prediction, RayCounts& rays);

    /// Whether the audit decides that the error is above the goal, or below it. The second needs
    /// more effective draws: otherwise audits that met too little of the error would end the
    /// search.
    bool is_decided(const ErrorEstimate& e) const;

    /// Whether the error is below the goal by so many standard errors.
    bool is_below(const ErrorEstimate& e, double margin) const;

    /// The last audit that decided.
    const Audit& last() const { return last_; }
    int last_draws() const { return static_cast<int>(last_.terms.size()); }

    int draws() const { return draws_; }
    void set_draws(int draws) { draws_ = draws; }
    /// Draws the next audits by what the last one has found.
    void learn_shares() { shares_ = best_shares(last_.seen); }

  private:
    Audit taken(const PictureSamples& samples, const Prediction& prediction, int draws,
                RayCounts& rays);

    const Truth& truth_;
    const double goal_;  ///< a mean square
    std::uint64_t audits_ = 0;
    int draws_ = 1000;
    DrawShares shares_ = first_shares;
    Audit last_;
};

}  // namespace lancer::accuracy
