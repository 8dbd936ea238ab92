#include "cli/validations.h"

#include <fmt/format.h>

#include <algorithm>
#include <thread>
#include <utility>

#include "base/parallel.h"
#include "judge/validate/validation_text.h"

namespace lancer::cli {

using judge::Validation;
using judge::ValidationJob;

Validations::Validations(const ValidateJob& options, std::vector<ValidationJob> jobs,
                         OtherSide other, Session& session)
    : options_(options),
      session_(session),
      jobs_(std::move(jobs)),
      other_(std::move(other)),
      bar_(session.terminal, options.quiet, 1) {
    shares_.resize(jobs_.size());
    for (std::size_t i = 0; i < jobs_.size(); ++i)
        jobs_[i].progress = [this, i](double share, const char* what) {
            show_progress(i, share, what);
        };
    for (const ValidationJob& job : jobs_) name_width_ = std::max(name_width_, job.name.size());
}

void Validations::run() {
    results_.resize(jobs_.size());
    done_.resize(jobs_.size());
    other_.report.entries.resize(jobs_.size());
    if (!options_.quiet) session_.output.say(judge::table_head(name_width_, other_.name));
    // POV-Ray sleeps while it starts, so two processes per core keep the cores busy.
    const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
    const auto workers = static_cast<int>(options_.jobs.value_or(2 * cores));
    for_each_task(static_cast<int>(jobs_.size()), workers, {}, [this](const NextTask& next) {
        for (int task = 0; next(task);) validate(static_cast<std::size_t>(task));
    });
}

/// An unexpected refusal is the scene's fault; any other failure is POV-Ray's.
static ExitCode exit_code_of(const Validation& v) {
    return v.refusals.empty() ? ExitCode::files : ExitCode::differs;
}

ExitCode Validations::finish() {
    bar_.clear();
    session_.write(options_.json, judge::validations_to_json(results_, other_.povray_version));
    session_.write(options_.junit,
                   judge::junit_xml("lancer validate", judge::junit_cases(results_)));
    if (!options_.report.empty()) {
        for (const judge::ReportEntry& entry : other_.report.entries)
            for (const judge::ReportFile& file : entry.files)
                session_.files.add_output_in_new_folder(options_.report + "/" + file.name,
                                                        "--report");
        judge::write_report(other_.report, options_.report);
        if (!options_.quiet)
            session_.output.say(fmt::format("wrote {}/index.html\n", options_.report));
    }
    ExitCode worst = ExitCode::done;
    for (const Validation& v : results_) {
        if (v.verdict == judge::Verdict::differs) worst = std::max(worst, ExitCode::differs);
        if (v.verdict == judge::Verdict::failed) worst = std::max(worst, exit_code_of(v));
    }
    return worst;
}

void Validations::show_progress(std::size_t job, double share, const char* what) {
    const std::lock_guard lock(mutex_);
    shares_[job] = share;
    double sum = 0;
    for (const double s : shares_) sum += s;
    bar_.set_label(jobs_.size() == 1 ? std::string(what)
                                     : fmt::format("{}: {}", jobs_[job].name, what));
    bar_.update(sum / static_cast<double>(shares_.size()));
}

void Validations::validate(std::size_t i) {
    Validation result = other_.judge(jobs_[i]);
    if (!options_.report.empty()) other_.report.entries[i] = judge::report_entry(result);
    result.ours = {};
    result.theirs = {};
    result.pov_text = {};
    result.pov_assets = {};
    const std::lock_guard lock(mutex_);
    results_[i] = std::move(result);
    done_[i] = true;
    shares_[i] = 1;
    show_lines();
}

void Validations::show_lines() {
    for (; shown_ < jobs_.size() && done_[shown_]; ++shown_) {
        bar_.clear();
        if (!options_.quiet) session_.output.say(judge::table_row(results_[shown_], name_width_));
    }
}

}  // namespace lancer::cli
