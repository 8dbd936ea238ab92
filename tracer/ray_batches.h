// Rays of many pixels, or through many points, in batches for the tracers of rays side by side.
#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "tracer/pixel_samples.h"
#include "tracer/render.h"
#include "tracer/tile_pixels.h"
#include "tracer/wide/wide_tracer.h"

namespace lancer {

/// Adds the light of all samples to the pixels of a tile, which begins at column left, row top of
/// the whole picture.
inline void add_samples(Image& tile, int left, int top, WideTracer& tracer,
                        const CameraFrame<double>& camera_frame, const View& view,
                        const Settings& settings) {
    RayBatch batch;
    std::array<double*, RayBatch::most> pixel_of;
    const auto trace_batch = [&] {
        tracer.trace(camera_frame, view.width, view.height, batch);
        for (std::size_t i = 0; i < static_cast<std::size_t>(batch.count); ++i) {
            for (int c = 0; c < 3; ++c) pixel_of[i][c] += batch.color[i][c];
        }
        batch.count = 0;
    };
    for_each_pixel(tile.width, tile.height, [&](int x, int y) {
        double* pixel = tile.pixel(x, y);
        for_each_sample<double>(settings, left + x, top + y, [&](double at_x, double at_y) {
            const auto i = static_cast<std::size_t>(batch.count++);
            batch.x[i] = at_x;
            batch.y[i] = at_y;
            pixel_of[i] = pixel;
            if (batch.count == RayBatch::most) trace_batch();
        });
    });
    if (batch.count != 0) trace_batch();
}

/// The light through at most RayBatch::most points.
inline void trace_points(std::span<const PicturePoint> points, WideTracer& tracer,
                         const CameraFrame<double>& camera_frame, const View& view,
                         std::span<Color> colors) {
    RayBatch batch;
    for (std::size_t i = 0; i < points.size(); ++i) {
        batch.x[i] = points[i].x;
        batch.y[i] = points[i].y;
    }
    batch.count = static_cast<int>(points.size());
    tracer.trace(camera_frame, view.width, view.height, batch);
    std::copy_n(batch.color.begin(), points.size(), colors.begin());
}

}  // namespace lancer
