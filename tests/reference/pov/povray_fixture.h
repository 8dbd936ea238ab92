// Tests that run POV-Ray. They are skipped with a message when it is not installed.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "model/diagnostic.h"
#include "reference/pov/export.h"
#include "reference/povray/runner.h"

namespace lancer::reference {

class WithPovRay : public testing::Test {
  protected:
    void SetUp() override {
        try {
            povray_ = find_povray();
        } catch (const FileError& error) {
            GTEST_SKIP() << "NOT TESTED: " << error.what();
        }
    }

    /// Exports, and fails the test with the reasons when something was refused.
    static ExportResult exported(const Scene& scene, const ExportView& view) {
        ExportResult result = export_pov(scene, view);
        for (const Diagnostic& refusal : result.refusals) ADD_FAILURE() << refusal.message;
        return result;
    }

    Image rendered(const ExportResult& scene, const ExportView& view) const {
        return rendered(scene.text, scene.assets, view);
    }
    Image rendered(const Scene& scene, const ExportView& view = {0, 48, 36}) const {
        return rendered(exported(scene, view), view);
    }
    Image rendered(const std::string& text, const std::vector<Asset>& assets,
                   const ExportView& view) const {
        PovJob job;
        job.text = text;
        job.assets = assets;
        job.width = view.width;
        job.height = view.height;
        try {
            return run_povray(povray_, job).image;
        } catch (const FileError& error) {
            ADD_FAILURE() << error.what() << "\n" << text;
            return Image(view.width, view.height);
        }
    }

    PovRay povray_;
};

/// The largest difference of two pictures of one size, and the share of pixels over `limit`.
struct Difference {
    double largest = 0;
    double share_over = 0;
};
inline Difference difference(const Image& a, const Image& b, double limit) {
    Difference d;
    std::size_t over = 0;
    const auto channels = static_cast<std::size_t>(a.channels);
    for (std::size_t i = 0; i < a.data.size(); i += channels) {
        double most = 0;
        for (std::size_t c = 0; c < channels; ++c)
            most = std::max(most, std::abs(a.data[i + c] - b.data[i + c]));
        d.largest = std::max(d.largest, most);
        over += most > limit ? 1 : 0;
    }
    d.share_over = static_cast<double>(over) * static_cast<double>(channels) /
                   static_cast<double>(a.data.size());
    return d;
}

}  // namespace lancer::reference
