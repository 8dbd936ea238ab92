// lancer join
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>

#include "accuracy/joined_report.h"
#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/error_words.h"
#include "cli/output_names.h"
#include "cli/picture_options.h"
#include "cli/progress.h"
#include "cli/session.h"
#include "cli/stopwatch.h"
#include "model/diagnostic.h"
#include "model/io/file.h"
#include "model/io/part_file.h"
#include "model/io/row_file.h"

namespace lancer::cli {
namespace {

struct JoinJob {
    std::vector<std::string> parts;
    std::string output;
    io::ImageWriteOptions image;
    bool quiet = false;
};

/// All parts of one picture, by their numbers.
class Parts {
  public:
    explicit Parts(const std::vector<std::string>& paths) {
        for (const std::string& path : paths) add(std::make_unique<io::PartReader>(path));
    }

    const io::PartHead& head() const { return first_->head(); }

    /// The missing numbers, as in "2, 5 to 7".
    std::string missing() const {
        std::string text;
        const int count = head().count;
        for (int number = 1; number <= count; ++number) {
            if (at(number)) continue;
            int last = number;
            while (last < count && !at(last + 1)) ++last;
            text += fmt::format("{}{}", text.empty() ? "" : ", ", number);
            if (last > number) text += fmt::format(" to {}", last);
            number = last;
        }
        return text;
    }

    /// The error of the whole picture from those of the parts; nothing when the parts were drawn
    /// without a target.
    std::optional<accuracy::ErrorReport> report() const {
        if (head().note.empty()) return std::nullopt;
        std::vector<accuracy::ErrorSums> sums;
        for (const auto& part : readers_) {
            const auto told = accuracy::error_sums_of(part->head().note);
            const bool fits =
                told && (sums.empty() || (told->audited == sums[0].audited &&
                                          told->off.has_value() == sums[0].off.has_value()));
            if (!fits) {
                throw FileError(fmt::format("'{}' is damaged: its error is missing", part->path()));
            }
            sums.push_back(*told);
        }
        return accuracy::joined_report(sums);
    }

    /// Reads the next row of the picture.
    void next(double* pixels) {
        if (row_ == 0) begin();
        const int number = owners_[static_cast<std::size_t>(row_)];
        at(number)->read_row(pixels);
        if (++row_ < head().height) return;
        for (const auto& part : readers_) part->finish();
    }

  private:
    std::unique_ptr<io::PartReader>& at(int number) {
        return readers_[static_cast<std::size_t>(number - 1)];
    }
    const std::unique_ptr<io::PartReader>& at(int number) const {
        return readers_[static_cast<std::size_t>(number - 1)];
    }

    void add(std::unique_ptr<io::PartReader> part) {
        const io::PartHead& head = part->head();
        if (first_ == nullptr) {
            first_ = part.get();
            readers_.resize(static_cast<std::size_t>(head.count));
        }
        const io::PartHead& wanted = first_->head();
        const auto refuse = [&](const std::string& what) {
            throw FileError(fmt::format("'{}' does not belong to '{}': it is of {}", part->path(),
                                        first_->path(), what));
        };
        if (head.count != wanted.count)
            refuse(fmt::format("{} parts, not {}", head.count, wanted.count));
        const std::string other = io::difference(head.origin, wanted.origin);
        if (!other.empty()) refuse(other);
        if (head.width != wanted.width || head.height != wanted.height ||
            head.extra_names != wanted.extra_names)
            refuse("another picture");
        if (at(head.number)) {
            throw FileError(fmt::format("'{}' and '{}' are both part {} of {}",
                                        at(head.number)->path(), part->path(), head.number,
                                        head.count));
        }
        at(head.number) = std::move(part);
    }

    /// Finds the part of each row.
    void begin() {
        owners_.resize(static_cast<std::size_t>(head().height));
        for (const auto& part : readers_)
            for (const io::Strip& strip : io::strips_of(part->head()))
                std::fill_n(owners_.begin() + strip.first, strip.rows, part->head().number);
    }

    std::vector<std::unique_ptr<io::PartReader>> readers_;
    const io::PartReader* first_ = nullptr;
    std::vector<int> owners_;
    int row_ = 0;
};

ExitCode run(const JoinJob& job, Session& session) {
    const Stopwatch watch;
    check_picture_name(job.output, job.image, false);
    for (const std::string& part : job.parts) session.files.add_input(part);
    session.will_write(job.output, "-o");
    Parts parts(job.parts);
    const io::PartHead& head = parts.head();
    if (const std::string missing = parts.missing(); !missing.empty()) {
        session.terminal.error(
            fmt::format("of {} parts, these are missing: {}", head.count, missing));
        return ExitCode::try_again;
    }
    Image like;
    like.width = head.width;
    like.height = head.height;
    like.channels = head.channels();
    like.extra_names = head.extra_names;
    check_picture_name(job.output, job.image, !head.extra_names.empty());
    const std::optional<accuracy::ErrorReport> report = parts.report();
    io::ImageWriteOptions written = job.image;
    if (report) written.notes = error_notes(*report);
    ProgressBar progress(session.terminal, job.quiet, 1);
    int rows = 0;
    io::write_rows(job.output, like, written, [&](double* pixels) {
        progress.update(static_cast<double>(rows++) / head.height);
        parts.next(pixels);
    });
    progress.clear();
    if (!job.quiet && !io::is_stream(job.output)) {
        session.output.say(fmt::format("wrote {} ({}x{}) from {} parts in {:.2f} s\n", job.output,
                                       head.width, head.height, head.count, watch.seconds()));
        if (report) session.output.say(fmt::format("{}\n", error_line(*report)));
    }
    return report && !report->is_reached() ? ExitCode::differs : ExitCode::done;
}

}  // namespace

void add_join(CLI::App& app, Action& action) {
    CLI::App& command =
        *app.add_subcommand("join", "Join the parts of a picture (made by render --part)");
    const auto job = std::make_shared<JoinJob>();
    command.add_option("PARTS", job->parts, "All parts, in any order")->required()->type_name("");
    command
        .add_option("-o,--output", job->output,
                    "Picture: .png .exr .hdr .tif .tiff .jpg .jpeg .ppm")
        ->required()
        ->type_name("OUT");
    add_encoding_options(command, job->image);
    command.add_flag("-q,--quiet", job->quiet, "Print no progress bar and no closing line");
    command.footer(
        "Examples:"
        "\n  lancer render scene.lancer --part 1/2"
        "\n  lancer render scene.lancer --part 2/2"
        "\n  lancer join scene-part-*-of-2.exr -o scene.png");
    command.callback(
        [&action, job] { action = [job](Session& session) { return run(*job, session); }; });
}

}  // namespace lancer::cli
