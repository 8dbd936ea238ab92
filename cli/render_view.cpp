#include "cli/render_view.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/memory_bound.h"
#include "model/diagnostic.h"

namespace lancer::cli {
namespace {

constexpr int preview_step = 4;  // pixels per pixel of the preview, on each side

int in_preview(int pixels) {
    return (pixels + preview_step - 1) / preview_step;
}

/// The new crop keeps each pixel of the smaller picture that contains a part of the old crop.
void make_coarser(View& view) {
    view.width = in_preview(view.width);
    view.height = in_preview(view.height);
    if (!view.crop) return;
    Crop& crop = *view.crop;
    const int right = in_preview(crop.x + crop.width);
    const int bottom = in_preview(crop.y + crop.height);
    crop.x /= preview_step;
    crop.y /= preview_step;
    crop.width = right - crop.x;
    crop.height = bottom - crop.y;
}

}  // namespace

View view_of(const RenderJob& job, const Scene& scene, const Session& session) {
    View view;
    view.camera = pick_camera(scene, job.camera, session);
    view.width = job.size ? job.size->width : scene.width;
    view.height = job.size ? job.size->height : scene.height;
    view.crop = job.crop;
    view.aov = job.aov;
    view.alpha = job.alpha;
    if (job.crop) check_crop(*job.crop, view.width, view.height);
    if (job.preview) make_coarser(view);
    const int width = view.crop ? view.crop->width : view.width;
    int height = view.crop ? view.crop->height : view.height;
    constexpr int most_strip_rows = 16;  // a part is written in strips, never held as a whole
    if (job.part && !job.frames)
        height = job.error.any() ? (height + job.part->count - 1) / job.part->count
                                 : std::min(height, most_strip_rows);
    constexpr int sampled = 20;  // sums, scores and predictions, as a number of channels
    const int channels = (job.aov ? 9 : 3) + (job.alpha ? 1 : 0) + (job.error.any() ? sampled : 0);
    const std::uint64_t needed = picture_bytes(width, height, channels);
    if (needed > available_memory()) {
        const std::string message =
            fmt::format("a picture of {}x{} pixels needs {:.1f} GB of memory, more than there is",
                        width, height, static_cast<double>(needed) / 1e9);
        if (job.size || job.crop) throw UsageError(message);
        throw SceneError({}, message);
    }
    return view;
}

}  // namespace lancer::cli
