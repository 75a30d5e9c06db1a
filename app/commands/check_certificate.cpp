#include <fmt/core.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <tl/expected.hpp>
#include <utility>

#include "analysis/numbers/constants.hpp"
#include "app/commands/commands.hpp"
#include "app/commands/computation.hpp"
#include "app/console/interrupt.hpp"
#include "app/console/messages.hpp"
#include "app/console/progress.hpp"
#include "app/documents/result_json.hpp"
#include "app/export/result_document.hpp"
#include "app/export/toml_text.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/certificate/recheck.hpp"
#include "problems/read.hpp"
#include "synthesis/search/deadline.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;
using problems::Counterexample;
using problems::PathProblem;

/// What a result states.
struct Statement {
  PathProblem problem;
  double lower_bound = 0;
  bool complete = false;
  std::optional<Counterexample> best;  ///< its first design
};

/// The number under `key`, as far as there is a finite one.
std::optional<double> number_under(const ordered_json& table, const char* key) {
  if (!table.is_object() || !table.contains(key) || !table[key].is_number()) return std::nullopt;
  const double value = table[key].get<double>();
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<Vec2d> pair_in(const ordered_json& array) {
  if (!array.is_array() || array.size() != 2 || !array[0].is_number() || !array[1].is_number()) {
    return std::nullopt;
  }
  return Vec2d{array[0].get<double>(), array[1].get<double>()};
}

/// The four-bar of a design; empty where it is not described whole.
std::optional<Counterexample> linkage_in(const ordered_json& design) {
  if (!design.is_object()) return std::nullopt;
  const ordered_json mechanism = design.value("mechanism", ordered_json::object());
  const ordered_json angles = design.value("crank_deg", ordered_json::array());
  const auto crank = number_under(mechanism, "crank"), coupler = number_under(mechanism, "coupler");
  const auto rocker = number_under(mechanism, "rocker");
  if (!crank || !coupler || !rocker || !mechanism.contains("fixed_pivots")) return std::nullopt;
  const ordered_json& pivots = mechanism["fixed_pivots"];
  if (!pivots.is_array() || pivots.size() != 2) return std::nullopt;
  const auto pivot_a = pair_in(pivots[0]), pivot_d = pair_in(pivots[1]);
  const auto point = pair_in(mechanism.value("coupler_point", ordered_json()));
  if (!pivot_a || !pivot_d || !point || !angles.is_array() || angles.empty() ||
      !angles[0].is_number()) {
    return std::nullopt;
  }
  const bool is_open = text_under(mechanism, "assembly") == "open";
  return Counterexample{{.pivot_a = *pivot_a,
                         .pivot_d = *pivot_d,
                         .crank = *crank,
                         .coupler = *coupler,
                         .rocker = *rocker,
                         .assembly = is_open ? Assembly::open : Assembly::crossed,
                         .coupler_point = point},
                        angles[0].get<double>() * kDegree,
                        0};
}

/// What `document` states, or what is wrong with it.
tl::expected<Statement, std::string> statement_in(const ordered_json& document) {
  const auto no = [](std::string what) { return tl::unexpected(std::move(what)); };
  if (!document.contains("certificate")) {
    return no("this result has no certificate; expected that of a file with solve.certify = true");
  }
  const ordered_json& certificate = document["certificate"];
  const auto lower = number_under(certificate, "lower_bound");
  const auto upper = number_under(certificate, "upper_bound");
  if (!lower || !upper || !(*lower >= 0) || !certificate.contains("complete") ||
      !certificate["complete"].is_boolean()) {
    return no("its certificate is damaged; expected lower_bound, upper_bound and complete");
  }
  if (*lower > *upper) {
    return no(
        fmt::format("certificate.lower_bound is {:.10g}, more than upper_bound, {:.10g}; "
                    "expected no more",
                    *lower, *upper));
  }
  const ordered_json problem = document.value("problem", ordered_json::object());
  const std::string kind = text_under(problem, "kind");
  if (kind != problems::KindTraits<PathProblem>::kWord) {
    return no(
        fmt::format("its problem is of kind \"{}\"; certificates are checked of "
                    "\"path-generation\"",
                    kind));
  }
  auto read = problems::parse_task<PathProblem>(toml_text(problem));
  if (!read) return no("its problem is damaged: " + read.error().front().message);
  if (read->timing != problems::Timing::prescribed || !read->solve.certify) {
    return no(
        "its problem has no certificate; expected prescribed timing and solve.certify = true");
  }
  const std::string refusal = problems::recheck_refusal(*read);
  if (!refusal.empty()) return no(refusal);
  const ordered_json designs = document.value("designs", ordered_json::array());
  const bool has_design = designs.is_array() && !designs.empty();
  return Statement{std::move(*read), *lower, certificate["complete"].get<bool>(),
                   has_design ? linkage_in(designs[0]) : std::nullopt};
}

problems::Recheck rechecked(const Statement& stated, int sample, const Options& options) {
  problems::Recheck found;
  if (stated.best)
    found.refutation = better_linkage(stated.problem, stated.lower_bound, {*stated.best});
  if (found.refutation || stated.lower_bound == 0) return found;
  const auto& interrupted = catch_interrupts();
  const synthesis::Deadline deadline(options.time_limit.value_or(kInfinity), &interrupted);
  Progress progress(options.quiet || options.json, interrupted);
  progress.enter("certificate", 1);
  return recheck(stated.problem, stated.lower_bound,
                 {.sample = static_cast<std::size_t>(sample),
                  .seed = options.seed,
                  .threads = options.threads,
                  .stop = [&] { return deadline.reached(); },
                  .progress = [&](double share) { progress.update(share, kInfinity); }});
}

ordered_json linkage_json(const Counterexample& found) {
  const FourBar& linkage = found.linkage;
  const Vec2d point = linkage.coupler_point.value_or(Vec2d{});
  return {{"error", found.error},
          {"fixed_pivots",
           {{linkage.pivot_a.x, linkage.pivot_a.y}, {linkage.pivot_d.x, linkage.pivot_d.y}}},
          {"crank", linkage.crank},
          {"coupler", linkage.coupler},
          {"rocker", linkage.rocker},
          {"assembly", linkage.assembly == Assembly::open ? "open" : "crossed"},
          {"coupler_point", {point.x, point.y}},
          {"first_crank_deg", problems::degrees(found.first_crank_angle)}};
}

ordered_json check_json(const std::filesystem::path& file, const Statement& stated,
                        const problems::Recheck& found) {
  ordered_json certificate = {{"lower_bound", stated.lower_bound},
                              {"complete", stated.complete},
                              {"boxes", found.boxes},
                              {"discarded", found.discarded},
                              {"reaches_bound", found.reaches_bound},
                              {"covers", found.covers},
                              {"chosen", found.chosen},
                              {"sampled", found.sampled},
                              {"confirmed", found.confirmed},
                              {"undecided", found.undecided},
                              {"parts", found.parts}};
  if (found.refutation) certificate["refutation"] = linkage_json(*found.refutation);
  return {{"format", "cognate-check/1"},
          {"file", file.string()},
          {"valid", found.holds() || (stated.lower_bound == 0 && !found.refutation)},
          {"certificate", certificate},
          {"faults", ordered_json::array()}};
}

std::string boxes_text(const problems::Recheck& found) {
  std::string text = fmt::format("{} boxes, {} of them discarded, ", found.boxes, found.discarded);
  if (!found.reaches_bound) {
    text += "do not reach the bound: the prover divides others further than it may, or was ended";
  } else {
    text += found.covers ? "cover the domain" : "do not cover the domain";
  }
  return text + fmt::format(
                    "\n{} of the discarded boxes checked again in 113 bits, by {} parts: {} "
                    "confirmed, {} undecided\n",
                    found.sampled, found.parts, found.confirmed, found.undecided);
}

std::string findings_text(const Statement& stated, const problems::Recheck& found) {
  std::string text = fmt::format("stated: no sum of squares below {:.10g}{}\n", stated.lower_bound,
                                 stated.complete ? "" : ", the last bound that time allowed");
  if (found.boxes > 0) text += boxes_text(found);
  if (found.refutation) {
    return text + fmt::format("REFUTED: a linkage has the sum of squares {:.10g}: {}\n",
                              found.refutation->error, linkage_json(*found.refutation).dump());
  }
  if (found.sampled < found.chosen) {
    text += fmt::format("ended before the other {}\n", found.chosen - found.sampled);
  }
  if (stated.lower_bound == 0) return text + "a bound of 0 needs no proof\n";
  return text + (found.holds() ? "confirmed\n" : "not confirmed\n");
}

}  // namespace

ExitStatus check_certificate_command(const std::filesystem::path& file, int sample,
                                     const Options& options) {
  const auto named = [&](const std::string& what) { return file.string() + ": " + what; };
  const auto document = read_result(file);
  if (!document) return refuse_result(file, document.error(), options);
  const auto stated = statement_in(*document);
  if (!stated) return refuse_result(file, named(stated.error()), options);
  const problems::Recheck found = rechecked(*stated, sample, options);
  const ordered_json json = check_json(file, *stated, found);
  const ExitStatus status = json["valid"].get<bool>() ? exit_done : exit_no_design;
  ExitStatus printed = exit_done;
  if (options.json) {
    printed = print(write_json(json));
  } else if (!options.quiet) {
    printed = print(printable(file.string()) + ": " + findings_text(*stated, found));
  }
  return printed == exit_done ? status : printed;
}

}  // namespace cognate::app
