/// @file The commands of the program. Each says what there is to say and returns how to end.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/console/messages.hpp"
#include "app/console/options.hpp"
#include "app/export/export_options.hpp"
#include "app/kinds/basics/command.hpp"
#include "app/study/part.hpp"

namespace cognate::app {

/// Solves the problem in `file`: prints the table of designs (with `--json` the result document,
/// with `--quiet` nothing) and writes NAME.result.json and NAME.report.html, NAME being the file's
/// stem, to the folder `--out`, else to the current one; with `--json` only where `--out` is given.
/// Whether they can be written is found out before anything is solved.
ExitStatus solve_command(const std::filesystem::path& file, const Options& options);

/// As `solve_command`, or of a mechanism `analyze_command`, whenever `file` is saved, until an
/// interrupt; faults are said and waited over. A file that is saved while it is computed is begun
/// anew. The status is that of the last run.
ExitStatus watch_command(Command command, const std::filesystem::path& file,
                         const Options& options);

/// Evaluates the mechanism in `file` over its drive: prints the quantities of its motion (with
/// `--json` the result document, with `--quiet` nothing) and writes NAME.result.json, NAME.csv and
/// NAME.report.html as `solve_command` does. The status is that of no design where the mechanism
/// cannot be assembled anywhere.
ExitStatus analyze_command(const std::filesystem::path& file, const Options& options);

/// The same of the mechanism of design number `design`, counted from 1, of the result document in
/// `file`, over the drive of its analysis or, of a synthesis, where it can be assembled. NAME is
/// that of the result followed by `.designN`.
ExitStatus analyze_design_command(const std::filesystem::path& file, int design,
                                  const Options& options);

class StudyProcesses;

/// What `cognate sweep` alone takes.
struct SweepOptions {
  StudyPart part;  ///< the designs that are evaluated
  /// Files of the same study, whose rows are taken over.
  std::vector<std::filesystem::path> merged;
  bool writes_columns = false;  ///< of the rows in the end, in NAME.study.h5
};

/// Takes over the rows of other files of the study in `file`, then evaluates the designs that are
/// not yet in NAME.study.db, NAME being the file's stem, in the folder `--out`, else the current
/// one, and stores their rows there; prints the counts and the best rows (with `--json` the
/// document `cognate-study/1`, with `--quiet` nothing) and writes NAME.report.html (with `--json`
/// only where `--out` is given). The status is that of no design where no row was kept. Of several
/// `processes` all are called; the first talks.
ExitStatus sweep_command(const std::filesystem::path& file, const Options& options,
                         const SweepOptions& own, StudyProcesses& processes);

/// Writes the base file of the study file `file` with the numbers of design `row` as NAME.ROW.toml
/// to the folder `--out`, else to the current one, NAME being the name of the study file without
/// `.study.db` or `.study.h5`. Says which file was written, as `export_command` does.
ExitStatus export_row_command(const std::filesystem::path& file, std::int64_t row,
                              const Options& options);

/// Writes a design of the result document in `file`, a linkage or a cam, as `exporting` says, to
/// the folder `--out`, else to the current one; NAME of the files is that of the result without
/// `.result.json`. Says which files were written (with `--json` as a document `cognate-export/1`,
/// with `--quiet` nothing).
ExitStatus export_command(const std::filesystem::path& file, const ExportOptions& exporting,
                          const Options& options);

/// Reads the problem in `file` without solving it and says what it is, or every fault in it; with
/// `--json` as a document `cognate-check/1`.
ExitStatus check_command(const std::filesystem::path& file, const Options& options);

/// Checks the certificate of the result document in `file` again: makes the boxes of its proof
/// anew, looks at `sample` of them by other code and in 113 bits, and says what came of it (with
/// `--json` as a document `cognate-check/1`). The status is that of no design where a box is
/// refuted or not confirmed, or the boxes do not cover the domain.
ExitStatus check_certificate_command(const std::filesystem::path& file, int sample,
                                     const Options& options);

/// Writes KIND.toml, a commented problem to start from, to the folder `--out`, else to the current
/// one, and says so (with `--json` as a document `cognate-new/1`, with `--quiet` not at all). A
/// file of that name is left as it is, and the status is that of bad input.
ExitStatus new_command(const std::string& kind, const Options& options);

/// Writes the page on which a curve is drawn and linkages are found that trace it, or where
/// `mechanism` holds the page on which a mechanism is built, to the file `--out`, else to
/// sketch.html or mechanism.html, and says so (with `--json` as a document `cognate-sketch/1`, with
/// `--quiet` not at all). A file of that name is left as it is, as by `new_command`.
/// `file`: of an analysis, whose mechanism is on the page then, which is that of mechanisms; or
/// empty.
ExitStatus sketch_command(bool mechanism, const std::string& file, const Options& options);

struct InvoluteOptions {
  bool inverse = false;  ///< the arguments are involutes, not angles
  bool csv = false;
};

/// Prints the involutes of the angles, in degrees, that `texts` give, each a number or a range
/// FROM:TO:STEP, or with `inverse` the angles of the involutes that they give; without any the
/// table of textbooks, 10° to 45°. As a table, as CSV or with `--json` as a document
/// `cognate-involute/1`.
ExitStatus involute_command(const std::vector<std::string>& texts, const InvoluteOptions& wanted,
                            const Options& options);

/// Prints the kinds of problems, mechanisms, solvers and options, or with `metrics` every metric
/// and every column with its unit; with `--json` as a document. With a `kind`, which may be empty,
/// what is of that kind.
ExitStatus list_command(const std::string& kind, bool metrics, const Options& options);

/// The document `cognate-list/1` that `list_command` prints; nothing where there is no such kind.
std::optional<nlohmann::ordered_json> list_document(const std::string& kind, bool metrics);

/// That there is no such kind, and which there are.
std::string unknown_kind(const std::string& kind);

}  // namespace cognate::app
