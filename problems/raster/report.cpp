#include "problems/raster/report.hpp"

#include <fmt/core.h>

#include <cctype>
#include <cmath>

namespace cognate::problems {
namespace {

/// |best − bound|/best; 0 where both are nothing.
double gap_of(double best, double bound) {
  return best > 0 ? std::abs(best - bound) / best : 0;
}

/// Whole numbers in full as far as that is readable.
std::string count(double number) {
  return number < 1e15 ? fmt::format("{:.0f}", number) : fmt::format("{:.4g}", number);
}

std::string capital(std::string_view word) {
  std::string with(word);
  if (!with.empty()) with.front() = static_cast<char>(std::toupper(with.front()));
  return with;
}

std::string coverage(const synthesis::RasterResult& found) {
  if (found.is_enumerated) {
    return fmt::format("Each of the {} combinations on the raster was evaluated: none is better.",
                       count(found.combinations));
  }
  if (found.is_complete && static_cast<double>(found.searched) >= found.combinations) {
    return fmt::format(
        "Each of the {} combinations on the raster was searched as a problem of its own: none "
        "better was found, which is no proof.",
        count(found.combinations));
  }
  if (found.is_complete && static_cast<double>(found.evaluated) >= found.combinations) {
    return fmt::format(
        "Each of the {} combinations on the raster was evaluated, what is free beside it from some "
        "starts: none better was found, which is no proof.",
        count(found.combinations));
  }
  if (found.is_complete) {
    return fmt::format(
        "All {} combinations on the raster are covered, {} of them evaluated; of the others no "
        "local minimum in their ranges is better, which is no proof.",
        count(found.combinations), found.evaluated);
  }
  if (!found.relaxed && found.ended_early) {
    return fmt::format(
        "The time ended before a design was found between the least and the greatest values of the "
        "raster, from which its {} combinations are searched.",
        count(found.combinations));
  }
  if (!found.relaxed) {
    return fmt::format(
        "Nothing that meets every constraint was found between the least and the greatest values "
        "of "
        "the raster, from which its {} combinations would be searched; wider bounds or a finer "
        "raster may help.",
        count(found.combinations));
  }
  return fmt::format(
      "{} of {} combinations on the raster are covered ({:.3g} %), {} of them evaluated; more "
      "boxes cover more.",
      count(found.covered), count(found.combinations), 100 * found.covered / found.combinations,
      found.evaluated);
}

}  // namespace

std::vector<Quantity> raster_quantities(const synthesis::RasterResult& found,
                                        const RasterMeasure& measure) {
  const auto key = [&](std::string_view of) { return fmt::format("{}_{}", of, measure.word); };
  std::vector<Quantity> all{
      {"raster_combinations", found.combinations},   {"raster_covered", found.covered},
      {"raster_evaluated", double(found.evaluated)}, {"raster_boxes", double(found.boxes)},
      {"raster_complete", found.is_complete},        {"raster_proven", found.is_enumerated}};
  if (found.relaxed) all.push_back({key("continuous"), measure.of(found.relaxed->objective)});
  if (found.rounded && std::isfinite(found.rounded->objective)) {
    all.push_back({key("rounded"), measure.of(found.rounded->objective)});
  }
  all.push_back({"rounded_feasible", found.rounded_is_accepted});
  if (found.designs.empty()) return all;
  const double best = measure.of(found.designs.front().objective);
  const double bound = measure.of(found.bound);
  all.push_back({key("raster"), best});
  all.push_back({"raster_bound", bound});
  all.push_back({"raster_gap", gap_of(best, bound)});
  return all;
}

std::vector<std::string> raster_notes(const synthesis::RasterResult& found,
                                      const RasterMeasure& measure) {
  std::vector<std::string> notes{coverage(found)};
  if (found.designs.empty()) {
    notes.emplace_back(found.is_enumerated
                           ? "No combination on the raster meets every constraint."
                           : "No combination on the raster was found that meets every "
                             "constraint.");
    return notes;
  }
  if (found.searched > 0 && static_cast<double>(found.searched) < found.combinations) {
    notes.push_back(fmt::format(
        "What is free beside the raster was searched anew for the {} most promising combinations.",
        found.searched));
  }
  if (!found.relaxed) return notes;
  const double best = measure.of(found.designs.front().objective);
  const double bound = measure.of(found.bound);
  const bool has_rounded = found.rounded && std::isfinite(found.rounded->objective);
  const std::string rounded =
      !has_rounded ? std::string("which cannot be rounded")
                   : fmt::format("which rounded has {:.4g}{}", measure.of(found.rounded->objective),
                                 found.rounded_is_accepted ? "" : " and breaks a constraint");
  const double continuous = measure.of(found.relaxed->objective);
  notes.push_back(fmt::format(
      "{} on the raster {:.4g}; of {} {:.4g}, {}; bound of the search {:.4g} (gap "
      "{:.3g} %).",
      capital(measure.word), best,
      continuous > best ? "the best that the search without it found" : "the continuous optimum",
      continuous, rounded, bound, 100 * gap_of(best, bound)));
  return notes;
}

}  // namespace cognate::problems
