// Rare light: bright specks far smaller than a pixel, which rays meet only by chance. If a picture
// met only a few of its specks, it missed others, and no audit's interval shows how many.
#pragma once

#include <vector>

#include "accuracy/audit.h"

namespace lancer::accuracy {

/// Whether `error` is a noticeable part of the squared error of a picture with this RMSE and this
/// number of pixels. `error` is squared and summed over pixels and channels.
bool is_noticed(double error, double rmse, double pixels_of_picture);

/// An estimate of the error from specks that no sample met.
struct Specks {
    double error = 0;                ///< squared, summed over pixels and channels
    double squares = 0;              ///< sum of squares of the pixels' contributions to `error`
    std::vector<PixelShare> pixels;  ///< the largest contributions, with their shares

    /// Whether no error can be told: `error` is noticed (is_noticed), and too few specks were met
    /// for an estimate of it.
    bool forbid(double rmse, double pixels_of_picture) const;
};

/// Remembers pixels whose first samples differ from those of their 8 neighbours, while the
/// neighbours are like each other.
class RareLight {
  public:
    /// Looks at a picture whose pixels all have the same number of samples.
    explicit RareLight(const PictureSamples& first);

    /// What those pixels differ by from those around them, squared and summed over channels. The
    /// samples are those that were looked at.
    double met_alone(const PictureSamples& first) const;

    /// Later samples decide which of the remembered pixels really differ from their neighbours.
    /// They also give the chance q that all first samples of such a pixel miss its speck. Each
    /// pixel then stands for q / (1 - q) pixels whose speck was missed (Horvitz and Thompson,
    /// "A generalization of sampling without replacement", JASA 47, 1952).
    Specks missed(const PictureSamples& later) const;

  private:
    std::vector<std::size_t> pixels_;
    double count_ = 0;  ///< first samples per pixel
};

}  // namespace lancer::accuracy
