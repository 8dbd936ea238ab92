// Pictures as programs of many makers write them: each file odd in a way of its own, and right.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <string>
#include <vector>

#include "model/io/image_file.h"
#include "tests/io/scratch_folder.h"

namespace lancer::io {

/// A file whose pixels are all one, as stored: of one grey, three or four channels.
struct OddPicture {
    const char* oddity;
    std::string bytes;
    int width, height;
    std::vector<double> pixel;
    double step = 1e-9;  ///< that may be lost
};

/// Each is read, has that size and that pixel everywhere.
inline void expect_read(const std::vector<OddPicture>& files) {
    EXPECT_GE(files.size(), 10u);
    const ScratchFolder folder;
    for (const OddPicture& file : files) {
        put(folder / "odd", file.bytes);
        try {
            const Image image = read_image(folder / "odd", ColorSpace::linear);
            EXPECT_EQ(image.width, file.width) << file.oddity;
            EXPECT_EQ(image.height, file.height) << file.oddity;
            const auto channels = static_cast<int>(file.pixel.size());
            if (image.color_channels() != channels) {
                ADD_FAILURE() << file.oddity << ": " << image.color_channels() << " channels";
                continue;
            }
            double worst = 0;
            for (int y = 0; y < image.height; ++y)
                for (int x = 0; x < image.width; ++x)
                    for (int c = 0; c < channels; ++c)
                        worst = std::max(worst, std::abs(image.pixel(x, y)[c] -
                                                         file.pixel[static_cast<std::size_t>(c)]));
            EXPECT_LE(worst, file.step) << file.oddity;
        } catch (const std::exception& error) {
            ADD_FAILURE() << file.oddity << ": " << error.what();
        }
    }
}

}  // namespace lancer::io
