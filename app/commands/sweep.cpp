#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <list>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "app/commands/commands.hpp"
#include "app/commands/computation.hpp"
#include "app/console/interrupt.hpp"
#include "app/console/messages.hpp"
#include "app/console/progress.hpp"
#include "app/console/terminal.hpp"
#include "app/documents/output_files.hpp"
#include "app/documents/result_json.hpp"
#include "app/documents/version.hpp"
#include "app/report/study_report.hpp"
#include "app/study/columns.hpp"
#include "app/study/database.hpp"
#include "app/study/evaluator.hpp"
#include "app/study/lock.hpp"
#include "app/study/merge.hpp"
#include "app/study/metrics.hpp"
#include "app/study/processes.hpp"
#include "app/study/read_columns.hpp"
#include "app/study/read_rows.hpp"
#include "app/study/run.hpp"
#include "app/study/summary.hpp"
#include "problems/toml/file_text.hpp"

namespace cognate::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kReportedRows = 5000;

/// One sweep: its input and where its files go.
struct Sweep {
  const problems::Study& study;
  StudyOrigin origin;
  const Options& options;
  const SweepOptions& own;
  fs::path folder;
  std::string stem;

  fs::path path(const char* ending) const { return folder / (stem + ending); }
  std::int64_t total() const { return problems::design_count(study); }
  /// What this run is to evaluate.
  DesignRange designs() const { return designs_of(own.part, total()); }
};

ExitStatus refuse_study(const std::string& what) {
  complain(what);
  return exit_bad_input;
}

EvaluatorMaker evaluators(const problems::Study& study, std::uint64_t seed) {
  return [&study, seed](const std::atomic<bool>* stopped) {
    return study_evaluator(study, seed, stopped);
  };
}

/// What is said of blocks without checksums, of the file `of` if it has a name.
std::string unchecked_words(std::int64_t blocks, const std::string& of) {
  return fmt::format(
      "{} blocks of rows{} have no checksums, having been stored without; whether they changed "
      "since is not known",
      grouped(blocks), of.empty() ? "" : " of " + of);
}

/// The other files whose rows are to be taken over by that in `own`.
std::list<OtherStudyFile> others_of(const Sweep& sweep, const fs::path& own) {
  std::list<OtherStudyFile> others;
  for (const fs::path& file : sweep.own.merged) {
    std::error_code error;
    const auto is_it = [&](const auto& other) { return fs::equivalent(file, other.file(), error); };
    if (std::ranges::any_of(others, is_it)) {
      throw StudyFileError(fmt::format("--merge: '{}' is named twice", file.string()));
    }
    others.emplace_back(file, own, sweep.study, sweep.origin);
  }
  return others;
}

/// Takes over the rows of other files; sentences on them.
std::vector<std::string> merge(const Sweep& sweep, std::list<OtherStudyFile> others,
                               StudyDatabase& database) {
  const auto& interrupted = catch_interrupts();
  std::vector<std::string> notes;
  const auto evaluated = [&] { return database.counts().evaluated; };
  Progress progress(sweep.options.quiet, interrupted, evaluated(), sweep.total());
  for (OtherStudyFile& other : others) {
    const std::int64_t designs =
        other.store_in(database, interrupted, [&] { progress.update(evaluated()); });
    const auto name = printable(other.file().string());
    notes.push_back(fmt::format("{} designs taken over from {}", grouped(designs), name));
    if (other.unchecked_blocks() > 0)
      notes.push_back(unchecked_words(other.unchecked_blocks(), name));
  }
  return notes;
}

/// Evaluates what is missing in `database`.
StudySummary run(const Sweep& sweep, StudyDatabase& database, StudyProcesses& processes) {
  const auto begun = std::chrono::steady_clock::now();
  const auto before = database.counts().evaluated;
  const auto total = sweep.total();
  WorkList work(within(database.missing(), sweep.designs()), block_size(sweep.study));
  StudySummary summary{.seed = sweep.origin.seed};
  {
    const auto crew =
        processes.crew(evaluators(sweep.study, sweep.origin.seed), work, sweep.options.threads);
    const auto& interrupted = catch_interrupts();
    Progress progress(sweep.options.quiet, interrupted, before, total);
    summary.threads = crew->size();
    summary.end = run_study(database, *crew,
                            {.interrupted = interrupted,
                             .time_limit = sweep.options.time_limit,
                             .progress = [&] { progress.update(database.counts().evaluated); },
                             .designs = sweep.designs()});
  }
  summary.counts = database.counts();
  summary.evaluated = summary.counts.evaluated - before;
  summary.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  if (const auto& part = sweep.own.part; part.count > 1) {
    const auto [first, count] = sweep.designs();
    summary.notes.push_back(fmt::format("part {} of {}: {} of {} designs, from number {} on",
                                        part.number, part.count, grouped(count), grouped(total),
                                        grouped(first)));
  }
  if (before > 0) {
    summary.notes.push_back(
        before == total
            ? "every design had been evaluated before; nothing was left to do"
            : fmt::format("continued after {} designs evaluated before", grouped(before)));
  }
  if (database.unchecked_blocks() > 0) {
    summary.notes.push_back(unchecked_words(database.unchecked_blocks(), ""));
  }
  return summary;
}

/// What an unfinished run leaves, and how to go on.
void say_end(const Sweep& sweep, const StudySummary& summary) {
  if (summary.end == StudyEnd::done) return;
  complain(fmt::format("{} after {} of {} designs; the same command continues from there",
                       summary.end == StudyEnd::interrupted ? "interrupted" : "time limit reached",
                       grouped(summary.counts.evaluated), grouped(sweep.total())));
}

/// Writes the rows as columns, where that is asked.
FileResult write_columns_of(const Sweep& sweep, StudyDatabase& database) {
  if (!sweep.own.writes_columns) return {};
  // An interrupted run, too, gives the rows so far; what may be interrupted now is the writing.
  std::atomic<bool> never{false};
  const auto& interrupted = catch_interrupts();
  Progress progress(sweep.options.quiet, interrupted, std::int64_t{0}, database.counts().kept);
  return write_columns(sweep.path(".study.h5"), database.connection(), sweep.study,
                       interrupted ? never : interrupted,
                       [&](std::int64_t rows) { progress.update(rows); });
}

/// The files that a run writes, as a line of the table.
std::string files_line(const Sweep& sweep) {
  const auto name = [&](const char* ending) {
    return printable(sweep.path(ending).lexically_normal().string());
  };
  const auto first = name(".study.db") + (sweep.own.writes_columns ? ", " + name(".study.h5") : "");
  return fmt::format("wrote {} and {}\n", first, name(".report.html"));
}

ExitStatus report(const Sweep& sweep, StudyDatabase& database, StudySummary& summary) {
  const auto& options = sweep.options;
  summary.best = best_rows(database.connection(), sweep.study, kListedRows);
  const auto document = study_document(sweep.study, summary);
  const bool has_report = !options.json || options.out;
  if (has_report) {
    const auto rows = report_rows(database.connection(), sweep.study, kReportedRows);
    const auto written = write_file(sweep.path(".report.html"),
                                    study_report_html(document, sweep.study, rows,
                                                      sweep.path(".study.db").filename().string()));
    if (!written) return refuse_study(written.error());
  }
  say_end(sweep, summary);
  if (const auto columns = write_columns_of(sweep, database); !columns) {
    return refuse_study(columns.error());
  }
  std::string text;
  if (options.json) {
    text = write_json(document);
  } else if (!options.quiet) {
    Screen screen = standard_output();
    screen.length = length_word(sweep.study.length_unit);
    text = study_table(sweep.study, summary, screen);
    text += files_line(sweep);
    text = fitted(text, screen);
  }
  const ExitStatus printed = print(text);
  if (printed != exit_done) return printed;
  return summary.counts.kept > 0 ? exit_done : exit_no_design;
}

/// Says that a run does not go on with the columns where its database would be, which is a fault
/// if they would be replaced; empty if there is nothing to say.
std::string unused_columns(const Sweep& sweep, const fs::path& database) {
  std::error_code error;
  const auto columns = sweep.path(".study.h5");
  if (fs::exists(database, error) || !fs::is_regular_file(columns, error)) return "";
  const auto is_it = [&](const fs::path& file) { return fs::equivalent(file, columns, error); };
  if (std::ranges::any_of(sweep.own.merged, is_it)) return "";
  return fmt::format(
      "'{0}' may hold rows of this study, but a run goes on with NAME.study.db alone; "
      "--merge {0} takes them over",
      columns.lexically_normal().string());
}

/// The part of the process that stores the rows.
ExitStatus direct(const Sweep& sweep, StudyProcesses& processes, std::string_view input) {
  std::vector<std::string> names{sweep.stem + ".study.db", sweep.stem + ".report.html"};
  if (sweep.own.writes_columns) names.push_back(sweep.stem + ".study.h5");
  auto ready = prepare_folder(sweep.folder, names);
  if (ready && sweep.own.writes_columns) ready = find_columns_module();
  const auto file = final_target(sweep.path(".study.db"));
  if (const auto unused = ready ? unused_columns(sweep, file) : ""; !unused.empty()) {
    if (sweep.own.writes_columns) {
      ready = tl::unexpected(unused + ", or remove it");
    } else if (!sweep.options.quiet) {
      complain("note: " + unused);
    }
  }
  const auto lock = ready ? StudyLock::take(lock_file(file)) : tl::unexpected(ready.error());
  std::optional<StudyDatabase> database;
  std::vector<std::string> merged;
  std::string fault = lock ? "" : lock.error();
  if (lock) {
    try {
      auto others = others_of(sweep, file);
      database.emplace(file, sweep.study, sweep.origin);
      merged = merge(sweep, std::move(others), *database);
    } catch (const StudyFileError& error) {
      fault = error.what();
    }
  }
  if (!processes.agree(fault.empty(), input)) {
    return fault.empty() ? exit_bad_input : refuse_study(fault);
  }
  try {
    auto summary = run(sweep, *database, processes);
    summary.notes.insert(summary.notes.begin(), merged.begin(), merged.end());
    return report(sweep, *database, summary);
  } catch (const StudyFileError& error) {
    return refuse_study(error.what());
  } catch (const SqliteError& error) {
    return refuse_study(
        fmt::format("cannot read '{}': {}", database->file().string(), error.what()));
  }
}

fs::path folder_of(const fs::path& file) {
  std::error_code error;
  return fs::absolute(file, error).parent_path();
}

tl::expected<problems::Study, std::vector<problems::Fault>> unreadable(const std::string& why) {
  return tl::unexpected(std::vector<problems::Fault>{{1, 1, why}});
}

}  // namespace

ExitStatus sweep_command(const fs::path& file, const Options& options, const SweepOptions& own,
                         StudyProcesses& processes) {
  // A file that may not grow is then an error of writing like any other.
  std::signal(SIGXFSZ, SIG_IGN);
  if (is_columns_file(file) || file.extension() == ".db") {
    processes.agree(false, "");
    return refuse_study(
        fmt::format("'{0}' holds rows; expected their study, NAME.toml, which takes "
                    "them over by --merge {0}",
                    file.string()));
  }
  // Once: a pipe gives its text no second time. Ctrl-C ends the program while it waits for one.
  const auto text = problems::reading::text_of(file);
  const auto study = text ? problems::parse_study(*text, folder_of(file), study_metrics)
                          : unreadable(text.error());
  if (!study) {
    processes.agree(false, "");
    return refuse(file, study.error(), options);
  }
  catch_interrupts();
  const Sweep sweep{
      .study = *study,
      .origin = {.text = *text, .version = std::string(version()), .seed = options.seed},
      .options = options,
      .own = own,
      .folder = options.out.value_or("."),
      .stem = file.stem().string()};
  const auto input = fmt::format("{}\n{}\n{}\n{}\n{}", sweep.origin.version, sweep.origin.seed,
                                 sweep.origin.text, study->base_text, study->drawing);
  if (processes.is_first()) return direct(sweep, processes, input);
  if (!processes.agree(true, input)) return exit_bad_input;
  processes.serve(evaluators(*study, options.seed), options.threads);
  return exit_done;
}

}  // namespace cognate::app
