// Light that single rays meet by luck: who has met few of its specks has missed others, and no
// interval can tell how many.
#pragma once

#include <vector>

#include "accuracy/audit.h"

namespace lancer::accuracy {

/// Remembers pixels whose first samples are unlike those of all 8 neighbours, which are alike.
class RareLight {
  public:
    /// Looks at a picture whose pixels all have the same number of samples.
    explicit RareLight(const Samples& first);

    /// What such specks in pixels that missed theirs add to the mean squared error. Later samples
    /// tell which of those pixels are alone indeed, and how likely first samples were to miss what
    /// is in them; each stands for as many as that makes likely (Horvitz and Thompson, "A
    /// generalization of sampling without replacement", JASA 47, 1952).
    struct Missed {
        double mean_square = 0;
        double effective_specks = 0;     ///< as many equal ones would weigh as much
        std::vector<PixelShare> pixels;  ///< the largest, with their shares

        /// Too few to judge by, and they matter for an RMSE of `error`.
        bool forbids(double error) const;
    };
    Missed missed(const Samples& later) const;

  private:
    std::vector<std::size_t> pixels_;
    double count_ = 0;  ///< first samples a pixel
};

}  // namespace lancer::accuracy
