#include "cli/render_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "cli/memory_bound.h"
#include "cli/output_names.h"
#include "cli/progress.h"
#include "cli/statistics.h"
#include "cli/stopwatch.h"
#include "model/io/file.h"
#include "tracer/render.h"

namespace lancer::cli {
namespace {

/// Names of frames that are looked at before the work begins; those of an endless animation come
/// one by one.
constexpr std::uint64_t most_frames_known = 100'000;

/// Options that contradict each other.
void check_options(const RenderJob& job) {
    if (job.loop && !job.frames) throw UsageError("--loop goes with --frames");
    const ErrorOptions& error = job.error;
    if (!error.any()) {
        if (error.no_audit)
            throw UsageError("--no-audit goes with --max-error, --max-off, --time or --passes");
        return;
    }
    const std::string option = error.max_error ? "--max-error"
                               : error.max_off ? "--max-off"
                               : error.seconds ? "--time"
                                               : "--passes";
    if (int(error.max_error.has_value()) + int(error.max_off.has_value()) +
            int(error.seconds.has_value()) + int(error.passes.has_value()) >
        1)
        throw UsageError("one of --max-error, --max-off, --time and --passes, not two");
    if (job.settings.samples)
        throw UsageError(option + " chooses the samples: leave --samples out");
    if (job.settings.quality)
        throw UsageError(option + " chooses samples and limits: leave --quality out");
    if (job.settings.sampling == Sampling::grid)
        throw UsageError(option + " samples at sobol points, not on a grid");
}

/// What can be said of the output's name before any work.
void check_format(const RenderJob& job, const std::string& output) {
    std::error_code ignored;
    if (std::filesystem::is_directory(output, ignored))
        throw FileError(fmt::format("cannot write '{}': it is a folder", output));
    if (!io::is_writable_image_name(output)) {
        throw UsageError(fmt::format(
            "'{}': the name of a picture ends in .png .exr .hdr .tif .tiff .jpg .jpeg or .ppm",
            output));
    }
    const std::string ending = ending_of(output);
    if (job.aov && ending != ".exr") throw UsageError("--aov needs an .exr file: -o OUT.exr");
    const bool is_deep =
        ending == ".png" || ending == ".tif" || ending == ".tiff" || ending == ".ppm";
    if (job.image.bits == 16 && !is_deep)
        throw UsageError(fmt::format("--bits 16 is for .png, .tif and .ppm, not for '{}'", output));
}

constexpr int preview_step = 4;  // pixels of the picture for one of the preview, on each side

int in_preview(int pixels) {
    return (pixels + preview_step - 1) / preview_step;
}

/// A crop keeps the pixels of the smaller picture that show some of it.
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

View view_of(const RenderJob& job, const Scene& scene, const Session& session) {
    View view;
    view.camera = pick_camera(scene, job.camera, session);
    view.width = job.size ? job.size->width : scene.width;
    view.height = job.size ? job.size->height : scene.height;
    view.crop = job.crop;
    view.aov = job.aov;
    if (job.crop) check_crop(*job.crop, view.width, view.height);
    if (job.preview) make_coarser(view);
    const int width = view.crop ? view.crop->width : view.width;
    const int height = view.crop ? view.crop->height : view.height;
    constexpr int sampled = 20;  // sums, scores and predictions, counted as channels
    const int channels = (job.aov ? 9 : 3) + (job.error.any() ? sampled : 0);
    const std::uint64_t needed = picture_bytes(width, height, channels);
    if (needed > available_memory()) {
        const std::string message =
            fmt::format("a picture of {}x{} pixels needs {:.1f} GB of memory, which is not there",
                        width, height, static_cast<double>(needed) / 1e9);
        if (job.size || job.crop) throw UsageError(message);
        throw SceneError({}, message);
    }
    return view;
}

class Rendering {
  public:
    Rendering(const RenderJob& job, Session& session)
        : job_(job),
          session_(session),
          loader_(job.scene, job.scene_options, session),
          progress_(session.terminal, job.quiet, frame_count(job)) {}

    /// One picture, from the script to the file.
    void render(double frame, double time, const std::string& output) {
        // What came before the first picture counts for it.
        const Stopwatch begun = statistics_.frames == 0 ? watch_ : Stopwatch();
        progress_.clear();  // the script may print
        Scene scene = loader_.load(frame, time);
        if (job_.preview) scene.settings.samples = 1;
        const View view = view_of(job_, scene, session_);
        if (statistics_.frames == 0) session_.terminal.show(missing_parts(scene), session_.sources);

        progress_.begin_part(statistics_.frames);
        io::ImageWriteOptions written = job_.image;
        const Image image = job_.error.any() ? image_by_error(scene, view, output, begun, written)
                                             : image_as_set(scene, view);
        const Stopwatch watch;
        io::write_image(output, image, written);
        statistics_.write += watch.seconds();
        late_ = late_ || (job_.error.seconds && is_late(begun.seconds(), *job_.error.seconds));
        ++statistics_.frames;
        width_ = image.width;
        height_ = image.height;
    }

    /// Statistics and the closing line.
    void finish(const std::string& what) {
        progress_.clear();
        statistics_.parse = loader_.parse_seconds();
        statistics_.evaluate = loader_.evaluate_seconds();
        statistics_.total = watch_.seconds();
        session_.write(job_.statistics,
                       job_.statistics == "-" ? to_text(statistics_) : to_json(statistics_));
        if (!job_.quiet && !io::is_stream(job_.output)) {
            session_.output.say(
                fmt::format("{} ({}x{}) in {:.2f} s\n", what, width_, height_, statistics_.total));
            if (statistics_.error)
                session_.output.say(fmt::format("{}\n", error_line(*statistics_.error)));
            if (late_)
                session_.output.say(
                    "the time was too short: the least that makes a picture took longer\n");
        }
    }

    ExitCode code() const {
        const bool missed = statistics_.error && !statistics_.error->is_reached();
        return missed || late_ ? ExitCode::differs : ExitCode::done;
    }

  private:
    Progress shown() {
        return [this](double share) { progress_.update(share); };
    }

    /// With the samples that the settings say.
    Image image_as_set(Scene& scene, const View& view) {
        job_.settings.apply_to(scene.settings);
        Stopwatch watch;
        const std::unique_ptr<Renderer> renderer = compile(scene, scene.settings, job_.level);
        statistics_.build += watch.seconds();
        statistics_.threads = scene.settings.threads;
        statistics_.level = name_of(renderer->level());
        watch = {};
        RayCounts rays;
        Image image = renderer->render(view, shown(), rays);
        statistics_.count(scene, renderer->counts());  // after: patches are cut when rays ask
        statistics_.trace += watch.seconds();
        statistics_.add(rays);
        return image;
    }

    /// With the samples that an error asks for, or that there is time for.
    Image image_by_error(const Scene& scene, const View& view, const std::string& output,
                         const Stopwatch& begun, io::ImageWriteOptions& written) {
        const Stopwatch watch;
        const auto run_of = [&] {
            const ErrorOptions& error = job_.error;
            if (error.max_error)
                return render_to_error(scene, job_.settings, error, job_.level, view, shown());
            if (error.max_off)
                return render_to_share(scene, job_.settings, error, job_.level, view, shown());
            return render_by_passes(
                scene, job_.settings, error, job_.level, view,
                {[&] { return begun.seconds(); },
                 [&](const Image& image) { show(image, view, output, begun); }});
        };
        ErrorRun run = run_of();
        statistics_.build += run.build_seconds;
        statistics_.trace += watch.seconds() - run.build_seconds;
        statistics_.count(scene, run.world);
        statistics_.level = name_of(run.level);
        Settings settings = scene.settings;
        job_.settings.apply_to(settings);
        statistics_.threads = settings.threads;
        for (const RayCounts& rays : {run.report.picture, run.report.deciding, run.report.printed})
            statistics_.add(rays);
        written.notes = error_notes(run.report);
        statistics_.keep_worse(run.report);
        return std::move(run.image);
    }

    /// The file is a whole picture early, and a better one later. A stream gets the last alone.
    void show(const Image& image, const View& view, const std::string& output,
              const Stopwatch& begun) {
        if (job_.error.seconds)
            progress_.update(std::min(0.99, begun.seconds() / *job_.error.seconds));
        if (!io::is_stream(output) && !view.aov) io::write_image(output, image, job_.image);
    }

    static bool is_late(double seconds, double asked) {
        return seconds > asked + std::max(0.05 * asked, 0.2);
    }

    static std::size_t frame_count(const RenderJob& job) {
        return job.frames ? static_cast<std::size_t>(job.frames->count()) : 1;
    }

    Stopwatch watch_;
    const RenderJob& job_;
    Session& session_;
    SceneLoader loader_;
    ProgressBar progress_;
    Statistics statistics_;
    int width_ = 0;
    int height_ = 0;
    bool late_ = false;
};

}  // namespace

ExitCode run(const RenderJob& job, Session& session) {
    const std::string output =
        job.output.empty() ? default_output(job.scene, job.preview) : job.output;
    check_options(job);
    check_format(job, output);
    if (!job.frames) {
        session.will_write(output, "-o");
        session.will_write(job.statistics, "--stats");
        Rendering rendering(job, session);
        rendering.render(0, 0, output);
        rendering.finish("wrote " + output);
        return rendering.code();
    }
    const FrameNames names(output);
    const FrameRange& frames = *job.frames;
    const auto will_write = [&](std::int64_t frame) {
        session.will_write(names.name(frame), fmt::format("frame {}", frame));
    };
    const std::int64_t last_known =
        frames.first + static_cast<std::int64_t>(std::min(frames.count(), most_frames_known)) - 1;
    for (std::int64_t frame = frames.first; frame <= last_known; ++frame) will_write(frame);
    session.will_write(job.statistics, "--stats");
    Rendering rendering(job, session);
    for (std::int64_t frame = frames.first; frame <= frames.last; ++frame) {
        if (frame > last_known) will_write(frame);
        rendering.render(static_cast<double>(frame), frames.time(frame, job.loop),
                         names.name(frame));
    }
    rendering.finish(fmt::format("wrote {} pictures, {} to {}", frames.count(),
                                 names.name(frames.first), names.name(frames.last)));
    return rendering.code();
}

}  // namespace lancer::cli
