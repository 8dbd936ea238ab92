// Light that single rays meet by luck: who has met few of its specks has missed others, and no
// interval can tell how many.
#pragma once

#include <vector>

#include "accuracy/audit.h"

namespace lancer::accuracy {

/// Whether so much squared error, summed over pixels and channels, matters for such an RMSE over so
/// many pixels.
bool is_noticed(double error, double rmse, double pixels_of_picture);

/// What specks in pixels that missed theirs add to a picture's error.
struct Specks {
    double error = 0;                ///< squared, summed over pixels and channels
    double squares = 0;              ///< of what each one adds
    std::vector<PixelShare> pixels;  ///< the largest, with their shares

    /// Too few to judge by, and they matter for such an RMSE over so many pixels.
    bool forbid(double rmse, double pixels_of_picture) const;
};

/// Remembers pixels whose first samples are unlike those of all 8 neighbours, which are alike.
class RareLight {
  public:
    /// Looks at a picture whose pixels all have the same number of samples.
    explicit RareLight(const PictureSamples& first);

    /// What those pixels differ by from those around them, squared and summed over channels. The
    /// samples are those that were looked at.
    double met_alone(const PictureSamples& first) const;

    /// Later samples tell which of those pixels are alone indeed, and how likely first samples were
    /// to miss what is in them; each stands for as many as that makes likely (Horvitz and Thompson,
    /// "A generalization of sampling without replacement", JASA 47, 1952).
    Specks missed(const PictureSamples& later) const;

  private:
    std::vector<std::size_t> pixels_;
    double count_ = 0;  ///< first samples a pixel
};

}  // namespace lancer::accuracy
