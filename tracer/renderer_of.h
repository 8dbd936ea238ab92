// The renderer for one number type. Each type is instantiated in its own file, render_*.cpp.
#pragma once

#include <cassert>
#include <mutex>
#include <string>

#include "base/parallel.h"
#include "tracer/compile/compile.h"
#include "tracer/overflow.h"
#include "tracer/pixel_samples.h"
#include "tracer/povray/recursion.h"
#include "tracer/ray_batches.h"
#include "tracer/ray_tree_renderer.h"
#include "tracer/rays/camera.h"
#include "tracer/recursion/cut_tracer.h"
#include "tracer/recursion/recorded_tracer.h"
#include "tracer/recursion/whitted.h"
#include "tracer/scene/far_camera.h"
#include "tracer/tile_order.h"
#include "tracer/tile_pixels.h"
#include "tracer/wide/wide_tracer.h"
#include "tracer/world_counts.h"

namespace lancer {

template <class Real>
class RendererOf final : public RayTreeRenderer {
  public:
    /// \param level  used if the number type and the world support it
    RendererOf(const Scene& scene, const Settings& settings, Level level = Level::scalar)
        : world_(compile_world<Real>(scene, settings)), cameras_(scene.cameras) {
        if constexpr (has_wide) {
            if (level != Level::scalar) wide_ = std::make_unique<WideWorld>(*world_, level);
        }
    }
    RendererOf(const Scene& scene, const Settings& settings, const PovRayRules& by_povray)
        : world_(compile_world<Real>(scene, settings, by_povray.followed ? &by_povray : nullptr)),
          cameras_(scene.cameras),
          povray_unit_(ldexp(static_cast<Real>(by_povray.unit), world_->scale_exponent)),
          by_povray_(by_povray.followed) {}

    void render_tiles(const View& view, const TakeTile& take, const Progress& progress,
                      RayCounts& counts) const override {
        const Crop crop = view.crop.value_or(Crop{0, 0, view.width, view.height});
        const int across = (crop.width + tile_size - 1) / tile_size;
        const int down = (crop.height + tile_size - 1) / tile_size;
        const TileOrder order(across, down);
        const CameraFrame<Real> camera_frame = camera_frame_of(view);
        std::mutex merging;
        constexpr std::int64_t nowhere = std::numeric_limits<std::int64_t>::max();
        std::int64_t overflow = nowhere;
        counts = {};
        for_each_task(order.count(), world_->settings.threads, progress, [&](auto next_task) {
            const auto work = [&](auto& tracer) {
                std::int64_t own_overflow = nowhere;
                Image tile(tile_size, tile_size, form_of(view).channels);
                for (int index = 0; next_task(index);) {
                    const std::optional<TilePlace> place = order[index];
                    if (!place) continue;
                    const int left = place->column * tile_size;
                    const int top = place->row * tile_size;
                    tile.width = std::min(tile_size, crop.width - left);
                    tile.height = std::min(tile_size, crop.height - top);
                    fill(tile, crop.x + left, crop.y + top, tracer, camera_frame, view);
                    take(left, top, tile);
                    if (const auto at = first_overflow(tile))
                        own_overflow = std::min(
                            own_overflow, std::int64_t(top + *at / tile.width) * crop.width + left +
                                              *at % tile.width);
                }
                const std::lock_guard lock(merging);
                counts += tracer.counts();
                overflow = std::min(overflow, own_overflow);
            };
            // Rays side by side compute no alpha.
            if (view.alpha)
                with_tracer(limits(), work);
            else
                with_fastest_tracer(limits(), camera_frame, work);
        });
        if (overflow != nowhere) refuse_overflow(overflow % crop.width, overflow / crop.width);
    }

    void trace(const View& view, std::span<const PicturePoint> points, const TraceLimits& limits,
               std::span<Color> colors, const Progress& progress,
               RayCounts& counts) const override {
        assert(colors.size() == points.size());
        assert(limits.max_depth <= world_->settings.max_depth);
        const CameraFrame<Real> camera_frame = camera_frame_of(view);
        std::mutex merging;
        trace_all(points, camera_frame, view, colors, progress, [&](auto&& work) {
            with_fastest_tracer(limits, camera_frame, [&](auto& tracer) {
                work(tracer);
                const std::lock_guard lock(merging);
                counts += tracer.counts();
            });
        });
        for (std::size_t i = 0; i < points.size(); ++i)
            if (overflows(&colors[i].x))
                refuse_overflow(static_cast<std::int64_t>(points[i].x),
                                static_cast<std::int64_t>(points[i].y));
    }

    void cut_shares(const View& view, std::span<const PicturePoint> points,
                    const TraceLimits& limits, std::span<Color> shares,
                    const Progress& progress) const override {
        assert(shares.size() == points.size());
        trace_all(points, camera_frame_of(view), view, shares, progress, [&](auto&& work) {
            CutTracer<Real> tracer(*world_, limits);
            work(tracer);
        });
    }

    Probe probe(const View& view, double x, double y) const override {
        ProbeRecord<Real> record;
        const CameraFrame<Real> camera_frame = camera_frame_of(view);
        Probe probe;
        with_tracer(limits(), [&](auto& tracer) {
            probe.color = convert<double>(sample(tracer, camera_frame, view, static_cast<Real>(x),
                                                 static_cast<Real>(y), &record));
            probe.rays = tracer.counts().rays();
        });
        probe.path = record.path;
        if (!record.met) return probe;
        probe.object = record.surface.primitive->object;
        probe.depth = unscaled(record.distance);
        probe.normal = convert<double>(record.surface.normal);
        probe.lit = record.lit;
        return probe;
    }

    std::vector<PicturePoint> samples(int x, int y) const override {
        std::vector<PicturePoint> points;
        for_each_sample<Real>(world_->settings, x, y, [&](Real at_x, Real at_y) {
            points.push_back({static_cast<double>(at_x), static_cast<double>(at_y)});
        });
        return points;
    }

    RayTree ray_tree(const View& view, const PicturePoint& at) const override {
        RayTree tree;
        const CameraFrame<Real> camera_frame = camera_frame_of(view);
        for_each_task(1, 1, {}, [&](auto next_task) {  // gives the deep stack that recursion needs
            RecordedTracer<Real> tracer(*world_, limits(), tree);
            for (int task = 0; next_task(task);)
                tree.color =
                    convert<double>(sample(tracer, camera_frame, view, static_cast<Real>(at.x),
                                           static_cast<Real>(at.y), nullptr));
        });
        return tree;
    }

    Level level() const override { return wide_ ? wide_->level() : Level::scalar; }

    WorldCounts counts() const override { return counts_of(*world_); }

  private:
    static constexpr int aov_channels = 6;
    /// Rays go side by side only in double.
    static constexpr bool has_wide = std::is_same_v<Real, double>;

    TraceLimits limits() const {
        return {world_->settings.max_depth, world_->settings.min_contribution};
    }

    /// Calls work(tracer) with the simplest tracer for this world. The judge's recursion uses the
    /// limits that it was compiled with.
    template <class Work>
    void with_tracer(const TraceLimits& limits, Work&& work) const {
        if constexpr (std::is_same_v<Real, double>) {
            if (povray_unit_) {
                with_second_tracer(*world_, *povray_unit_, by_povray_, work);
                return;
            }
        }
        if (is_all_opaque(*world_)) {
            OpaqueTracer<Real> tracer(*world_, limits);
            work(tracer);
        } else {
            Whitted<Real> tracer(*world_, limits);
            work(tracer);
        }
    }

    /// The same with the tracer that is fastest for many rays: one for rays side by side, if it can
    /// be used.
    template <class Work>
    void with_fastest_tracer(const TraceLimits& limits, const CameraFrame<Real>& camera_frame,
                             Work&& work) const {
        if constexpr (has_wide) {
            if (wide_) {
                if (const auto tracer = wide_->tracer(limits, camera_frame)) {
                    work(*tracer);
                    return;
                }
            }
        }
        with_tracer(limits, work);
    }

    CameraFrame<Real> camera_frame_of(const View& view) const {
        const Camera& camera = cameras_[view.camera];
        CameraFrame<Real> camera_frame =
            make_camera_frame<Real>(camera, view.width, view.height, world_->scale_exponent);
        begin_near_scene(*world_, camera, camera_frame);
        return camera_frame;
    }
    double unscaled(Real distance) const {
        return static_cast<double>(ldexp(distance, -world_->scale_exponent));
    }

    /// One ray through the point (x, y), in pixels of the whole picture.
    template <class Tracer>
    Vec3<Real> sample(Tracer& tracer, const CameraFrame<Real>& camera_frame, const View& view,
                      Real x, Real y, ProbeRecord<Real>* record) const {
        const Real sx = x / static_cast<Real>(view.width) - Real(0.5);
        const Real sy = Real(0.5) - y / static_cast<Real>(view.height);
        const Ray<Real> ray = camera_ray(camera_frame, sx, sy);
        if (camera_frame.ahead == 0) return tracer.camera_ray(ray, Real(0), ray, record);
        const Real at_camera = camera_parameter(camera_frame, sx, sy);
        const Vec3<Real> color =
            tracer.camera_ray(ray, at_camera, ray_from_camera(camera_frame, sx, sy), record);
        if (record != nullptr && record->met) record->distance -= at_camera;
        return color;
    }

    /// \param light   mean of the samples, without the background's light
    /// \param behind  mean share of the background
    static void put_with_alpha(double* pixel, const Vec3<Real>& light, const Vec3<Real>& behind) {
        const Real share = (behind.x + behind.y + behind.z) / 3;
        const Real alpha = share < 1 ? 1 - share : Real(0);
        put_mean(pixel, alpha > 0 ? light / alpha : Vec3<Real>(0));
        pixel[3] = static_cast<double>(alpha);
    }

    /// Fills a tile, which begins at column left, row top of the whole picture.
    template <class Tracer>
    void fill(Image& tile, int left, int top, Tracer& tracer, const CameraFrame<Real>& camera_frame,
              const View& view) const {
        const int n = world_->settings.samples;
        for (int y = 0; y < tile.height; ++y) {
            for (int x = 0; x < tile.width; ++x) {
                Vec3<Real> sum(0);
                Vec3<Real> behind(0);
                for_each_sample<Real>(
                    world_->settings, left + x, top + y, [&](Real at_x, Real at_y) {
                        Vec3<Real> share(0);
                        if constexpr (requires { tracer.seen_through; })
                            tracer.seen_through = view.alpha ? &share : nullptr;
                        sum += sample(tracer, camera_frame, view, at_x, at_y, nullptr);
                        behind += share;
                    });
                const Real count = n == 1 ? Real(1) : static_cast<Real>(n * n);
                double* pixel = tile.pixel(x, y);
                if (view.alpha)
                    put_with_alpha(pixel, sum / count, behind / count);
                else
                    put_mean(pixel, n == 1 ? sum : sum / count);
                if (view.aov)
                    fill_aov(pixel + (view.alpha ? 4 : 3), camera_frame, view, left + x, top + y);
            }
        }
    }

    /// The same, many rays at a time.
    void fill(Image& tile, int left, int top, WideTracer& tracer,
              const CameraFrame<Real>& camera_frame, const View& view) const {
        std::fill(tile.data.begin(), tile.data.end(), 0.0);
        add_samples(tile, left, top, tracer, camera_frame, view, world_->settings);
        const int n = world_->settings.samples;
        if (n == 1 && !view.aov) return;
        for_each_pixel(tile.width, tile.height, [&](int x, int y) {
            double* pixel = tile.pixel(x, y);
            for (int c = 0; c < 3 && n > 1; ++c) pixel[c] /= n * n;
            if (view.aov) fill_aov(pixel + 3, camera_frame, view, left + x, top + y);
        });
    }

    /// Traces one ray through each of the points. Each thread calls with_tracer(work), which calls
    /// work(tracer).
    template <class WithTracer>
    void trace_all(std::span<const PicturePoint> points, const CameraFrame<Real>& camera_frame,
                   const View& view, std::span<Color> colors, const Progress& progress,
                   WithTracer&& with_tracer) const {
        constexpr std::size_t stretch = 256;
        const int stretches = static_cast<int>((points.size() + stretch - 1) / stretch);
        for_each_task(stretches, world_->settings.threads, progress, [&](auto next_task) {
            with_tracer([&](auto& tracer) {
                for (int index = 0; next_task(index);) {
                    const std::size_t begin = static_cast<std::size_t>(index) * stretch;
                    const std::size_t count = std::min(stretch, points.size() - begin);
                    trace_some(points.subspan(begin, count), tracer, camera_frame, view,
                               colors.subspan(begin, count));
                }
            });
        });
    }

    template <class Tracer>
    void trace_some(std::span<const PicturePoint> points, Tracer& tracer,
                    const CameraFrame<Real>& camera_frame, const View& view,
                    std::span<Color> colors) const {
        for (std::size_t i = 0; i < points.size(); ++i)
            colors[i] =
                convert<double>(sample(tracer, camera_frame, view, static_cast<Real>(points[i].x),
                                       static_cast<Real>(points[i].y), nullptr));
    }

    /// At most RayBatch::most points.
    static void trace_some(std::span<const PicturePoint> points, WideTracer& tracer,
                           const CameraFrame<Real>& camera_frame, const View& view,
                           std::span<Color> colors) {
        trace_points(points, tracer, camera_frame, view, colors);
    }

    static void put_mean(double* pixel, const Vec3<Real>& mean) {
        const Vec3d color = convert<double>(mean);
        for (int c = 0; c < 3; ++c) pixel[c] = color[c];
    }

    /// Traces its own ray through the pixel's centre, which is not counted.
    void fill_aov(double* out, const CameraFrame<Real>& camera_frame, const View& view, int x,
                  int y) const {
        ProbeRecord<Real> record;
        with_tracer(limits(), [&](auto& tracer) {
            sample(tracer, camera_frame, view, static_cast<Real>(x) + Real(0.5),
                   static_cast<Real>(y) + Real(0.5), &record);
        });
        std::fill(out, out + aov_channels, 0.0);
        out[0] = -1;
        if (!record.met) return;
        out[0] = record.surface.primitive->object;
        out[1] = unscaled(record.distance);
        for (int c = 0; c < 3; ++c) out[2 + c] = static_cast<double>(record.surface.normal[c]);
        const std::size_t lights = std::min<std::size_t>(world_->lights.size(), 64);
        std::size_t dark = 0;
        for (std::size_t i = 0; i < lights; ++i) dark += (record.lit >> i & 1) == 0;
        out[5] = lights == 0 ? 0.0 : static_cast<double>(dark) / static_cast<double>(lights);
    }

    std::unique_ptr<World<Real>> world_;
    std::unique_ptr<WideWorld> wide_;  ///< null if rays go one by one
    std::vector<Camera> cameras_;
    std::optional<Real> povray_unit_;  ///< if set, the judge's recursion traces rays ...
    bool by_povray_ = false;           ///< ... and this chooses POV-Ray's rules
};

}  // namespace lancer
