#include "cli/render_job.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/cut_words.h"
#include "cli/error_words.h"
#include "cli/output_names.h"
#include "cli/part_job.h"
#include "cli/progress.h"
#include "cli/render_checks.h"
#include "cli/render_view.h"
#include "cli/resume.h"
#include "cli/run_origin.h"
#include "cli/statistics.h"
#include "cli/stopwatch.h"
#include "model/io/file.h"
#include "model/io/tiled_picture.h"
#include "tracer/render.h"

namespace lancer::cli {
namespace {

/// Frame names are checked before the work begins, up to this number; a longer animation checks
/// each name when its turn comes.
constexpr std::uint64_t most_frames_known = 100'000;

class Rendering {
  public:
    Rendering(const RenderJob& job, Session& session)
        : job_(job),
          session_(session),
          loader_(job.scene, job.scene_options, session, job.settings.reading_threads()),
          progress_(session.terminal, job.quiet, frame_count(job)) {}

    /// Makes one picture, from the script to the file. `is_last`: no other follows.
    void render(double frame, double time, const std::string& output, bool is_last) {
        // The time before the first picture belongs to that picture.
        const Stopwatch begun = statistics_.frames == 0 ? watch_ : Stopwatch();
        progress_.clear();  // the script may print
        Scene scene = is_last ? loader_.load_last(frame, time) : loader_.load(frame, time);
        if (job_.preview) scene.settings.samples = 1;
        const View view = view_of(job_, scene, session_);
        if (pictures_ == 0) session_.terminal.show(missing_parts(scene), session_.sources);

        progress_.begin_part(pictures_++);
        std::optional<io::Origin> origin;
        if (is_part() || job_.resume) {
            Settings settings = scene.settings;
            job_.settings.apply_to(settings);
            origin = origin_of(job_, loader_, scene, settings, view, frame, time);
        }
        std::optional<io::PartHead> head;
        if (is_part()) head = head_of(*job_.part, view, *origin, job_.error.any());
        const Image form = form_of(view);
        width_ = form.width;
        height_ = form.height;
        if (job_.resume && is_kept(output, *origin, head)) return;
        if (head && job_.error.any()) {
            part_by_error(scene, view, *head, output, begun);
        } else if (head) {
            part_as_set(scene, view, *head, output);
        } else if (job_.error.any()) {
            picture_by_error(scene, view, origin, output, begun);
        } else {
            picture_as_set(scene, view, origin, output);
        }
        late_ = late_ || (job_.error.seconds && is_late(begun.seconds(), *job_.error.seconds));
        ++statistics_.frames;
    }

    std::uint64_t drawn() const { return statistics_.frames; }
    std::uint64_t kept() const { return pictures_ - statistics_.frames; }

    /// Writes the statistics and the closing line.
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
                session_.output.say(fmt::format("{}{}\n", is_part() ? "this part: " : "",
                                                error_line(*statistics_.error)));
            if (statistics_.cut) session_.output.say(cut_line(*statistics_.cut) + "\n");
            if (late_)
                session_.output.say(
                    "the time was too short: even the fewest rays that make a picture took "
                    "longer\n");
        }
    }

    /// A part may have a larger error than the target: only `join` knows the error of the picture.
    ExitCode code() const {
        const bool missed = statistics_.error && !is_part() && !statistics_.error->is_reached();
        return missed || late_ ? ExitCode::differs : ExitCode::done;
    }

  private:
    bool is_part() const { return job_.part && !job_.frames; }

    Progress shown() {
        return [this](double share) { progress_.update(share); };
    }

    /// Whether the existing file is what this run would draw. Otherwise says why it is not.
    bool is_kept(const std::string& output, const io::Origin& origin,
                 const std::optional<io::PartHead>& head) {
        const Found found = head ? found_part(output, *head) : found_picture(output, origin);
        if (found.reason.empty()) return found.is_kept;
        progress_.clear();
        session_.terminal.line(fmt::format("{} is rendered again: {}", output, found.reason));
        return false;
    }

    std::unique_ptr<Renderer> built(Scene& scene) {
        job_.settings.apply_to(scene.settings);
        const Stopwatch watch;
        std::unique_ptr<Renderer> renderer = compile(scene, scene.settings, job_.level);
        statistics_.build += watch.seconds();
        statistics_.threads = scene.settings.threads;
        statistics_.level = name_of(renderer->level());
        return renderer;
    }

    void count(const Scene& scene, const Renderer& renderer, double seconds,
               const RayCounts& rays) {
        // at the end, because rays cut patches on demand
        statistics_.count(scene, renderer.counts());
        statistics_.trace += seconds;
        statistics_.add(rays);
    }

    /// Renders with the number of samples from the settings.
    void picture_as_set(Scene& scene, const View& view, const std::optional<io::Origin>& origin,
                        const std::string& output) {
        const std::unique_ptr<Renderer> renderer = built(scene);
        const Stopwatch watch;
        RayCounts rays;
        io::TiledPicture picture(output, form_of(view), job_.image, origin);
        const auto put = [&](int x, int y, const Image& tile) { picture.put(x, y, tile); };
        renderer->render_tiles(view, put, shown(), rays);
        count(scene, *renderer, watch.seconds(), rays);
        if (job_.bound_cut || job_.settings.quality == Quality::exact) {
            const TraceLimits limits{scene.settings.max_depth, scene.settings.min_contribution};
            const auto points = [&](int x, int y) { return renderer->samples(x, y); };
            statistics_.keep_larger(
                accuracy::bound_of_cut(*renderer, scene, view, limits, points, shown()));
        }
        const Stopwatch writing;
        picture.write();
        statistics_.write += writing.seconds();
    }

    /// The same with a target error.
    void picture_by_error(const Scene& scene, const View& view,
                          const std::optional<io::Origin>& origin, const std::string& output,
                          const Stopwatch& begun) {
        const ErrorRun run = run_by_error(scene, view, std::nullopt, output, begun);
        io::ImageWriteOptions written = job_.image;
        written.notes = error_notes(run.report);
        const Stopwatch watch;
        if (origin)
            io::write_image(output, run.image, written, *origin);
        else
            io::write_image(output, run.image, written);
        statistics_.write += watch.seconds();
    }

    /// The same for one part, written strip by strip.
    void part_as_set(Scene& scene, const View& view, const io::PartHead& head,
                     const std::string& output) {
        const std::unique_ptr<Renderer> renderer = built(scene);
        const Stopwatch watch;
        RayCounts rays;
        draw_part(*renderer, view, head, output, shown(), rays);
        count(scene, *renderer, watch.seconds(), rays);
    }

    /// The same for one part with a target error.
    void part_by_error(const Scene& scene, const View& view, io::PartHead head,
                       const std::string& output, const Stopwatch& begun) {
        const ErrorRun run = run_by_error(scene, view, rows_of(head), output, begun);
        head.note = accuracy::to_text(run.sums);
        const Stopwatch watch;
        write_drawn(run.image, head, output);
        statistics_.write += watch.seconds();
    }

    /// Renders with a target error, or within a time.
    ErrorRun run_by_error(const Scene& scene, const View& view,
                          const std::optional<accuracy::PictureRows>& rows,
                          const std::string& output, const Stopwatch& begun) {
        const Stopwatch watch;
        const auto run_of = [&] {
            const ErrorOptions& error = job_.error;
            if (error.max_error)
                return render_to_error(scene, job_.settings, error, job_.level, view, rows,
                                       shown());
            if (error.max_off)
                return render_to_share(scene, job_.settings, error, job_.level, view, rows,
                                       shown());
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
        statistics_.keep_worse(run.report);
        return run;
    }

    /// Writes a whole picture early and better ones later. A stream gets only the last.
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
    std::uint64_t pictures_ = 0;  ///< drawn and kept
    int width_ = 0;
    int height_ = 0;
    bool late_ = false;
};

}  // namespace

namespace {

std::string default_name(const RenderJob& job) {
    if (job.part && !job.frames) return default_part(job.scene, job.part->number, job.part->count);
    return default_output(job.scene, job.preview);
}

std::string closing_line(const Rendering& rendering, const FrameNames& names,
                         const FrameRange& frames) {
    const std::string kept = rendering.kept() > 0 ? fmt::format(", kept {}", rendering.kept()) : "";
    return fmt::format("wrote {} pictures{}, {} to {}", rendering.drawn(), kept,
                       names.name(frames.first), names.name(frames.last));
}

ExitCode run_animation(const RenderJob& job, const std::string& output, Session& session) {
    const FrameNames names(output);
    const FrameRange& frames = *job.frames;
    const auto is_ours = [&](std::int64_t frame) {
        return !job.part || job.part->has(frame - frames.first);
    };
    const auto will_write = [&](std::int64_t frame) {
        if (is_ours(frame)) session.will_write(names.name(frame), fmt::format("frame {}", frame));
    };
    const std::int64_t last_known =
        frames.first + static_cast<std::int64_t>(std::min(frames.count(), most_frames_known)) - 1;
    for (std::int64_t frame = frames.first; frame <= last_known; ++frame) will_write(frame);
    session.will_write(job.statistics, "--stats");
    Rendering rendering(job, session);
    for (std::int64_t frame = frames.first; frame <= frames.last; ++frame) {
        if (frame > last_known) will_write(frame);
        if (!is_ours(frame)) continue;
        rendering.render(static_cast<double>(frame), frames.time(frame, job.loop),
                         names.name(frame), frame == frames.last);
    }
    rendering.finish(closing_line(rendering, names, frames));
    return rendering.code();
}

}  // namespace

ExitCode run(const RenderJob& job, Session& session) {
    const std::string output = job.output.empty() ? default_name(job) : job.output;
    check(job, output);
    if (job.frames) return run_animation(job, output, session);
    session.will_write(output, "-o");
    session.will_write(job.statistics, "--stats");
    Rendering rendering(job, session);
    rendering.render(0, 0, output, true);
    rendering.finish((rendering.kept() > 0 ? "kept " : "wrote ") + output);
    return rendering.code();
}

}  // namespace lancer::cli
