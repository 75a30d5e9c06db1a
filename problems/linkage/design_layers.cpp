#include "problems/linkage/design_layers.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "analysis/mechanism/assembly_ranges.hpp"
#include "analysis/numbers/parallel.hpp"
#include "problems/layers/assign.hpp"
#include "problems/layers/keys.hpp"
#include "problems/layers/notes.hpp"
#include "problems/linkage/verify.hpp"

namespace cognate::problems {
namespace {

bool slides(const Design& design) {
  return driven_by_length(design.mechanism.mechanism.drive);
}

/// The drive coordinates at the targets: crank angles, or the displacements "slide_1"…
std::vector<double> stations_of(const Design& design) {
  if (!slides(design)) return design.crank_angles;
  std::vector<double> stations;
  for (const Quantity& quantity : design.metrics.quantities) {
    const auto* value = std::get_if<double>(&quantity.value);
    if (value && quantity.name.starts_with("slide_")) stations.push_back(*value);
  }
  return stations;
}

/// Over the motion in which the design is drawn; the error says why there are none.
tl::expected<LayerResult, std::string> layers_of(const Design& design, const LayerSizes& sizes,
                                                 const Deadline& deadline) {
  const auto& mechanism = design.mechanism.mechanism;
  const auto span = motion_span(design);
  if (!span) {
    return tl::unexpected(
        std::string("the links have no layers: the mechanism can be assembled nowhere"));
  }
  return assign_layers(design.mechanism, follow(mechanism, span->from, span->to), sizes,
                       [&] { return deadline.reached(); });
}

/// Leaves the designs of these places, in this order; the places of cognates and mirror images
/// follow.
void keep(std::vector<Design>& designs, const std::vector<std::size_t>& order) {
  std::vector<int> places(designs.size(), -1);
  for (std::size_t i = 0; i < order.size(); ++i) places[order[i]] = static_cast<int>(i);
  std::vector<Design> kept;
  for (const std::size_t from : order) {
    Design& design = designs[from];
    for (auto* index : {&design.cognate_of, &design.mirror_of}) {
      if (!*index) continue;
      const int place = places[static_cast<std::size_t>(**index)];
      *index = place >= 0 && place < std::ssize(kept) ? std::optional(place) : std::nullopt;
    }
    kept.push_back(std::move(design));
  }
  designs = std::move(kept);
}

/// Layers that a design needs; more than any where it has none.
int needed(const Design& design) {
  constexpr int kNone = std::numeric_limits<int>::max();
  return design.layers ? design.layers->count.value_or(kNone) : kNone;
}

ConstraintCheck check_of(const Design& design, int max) {
  ConstraintCheck check{.name = std::string(reading::kLayersMaxKeys.front().name),
                        .value = std::string("none"),
                        .bound = static_cast<double>(max),
                        .satisfied = needed(design) <= max};
  if (design.layers && design.layers->count) {
    check.value = static_cast<double>(*design.layers->count);
  }
  return check;
}

void add_work(const Work& more, Work& sum) {
  for (std::uint64_t Work::*count :
       {&Work::candidates, &Work::positions, &Work::velocities, &Work::accelerations,
        &Work::reactions, &Work::gradients, &Work::solver_iterations}) {
    sum.*count += more.*count;
  }
  sum.seconds += more.seconds;
}

bool is_met(const Design& design) {
  return all_satisfied(design.constraints);
}

void add_layer_note(std::string note, Result& result) {
  if (note.empty() || std::ranges::count(result.notes, note) > 0) return;
  result.notes.push_back(std::move(note));
}

/// Why a design has no layers.
std::string blocked_design(std::ptrdiff_t index, const Design& design) {
  return fmt::format("Design {}: {}", index + 1, blocked_note(*design.layers, slides(design)));
}

/// How many designs that were passed over are better than the first that fits.
void note_passed(const std::vector<std::size_t>& passed, std::size_t first, int max,
                 Result& result) {
  const auto better = std::ranges::count_if(passed, [&](std::size_t i) { return i < first; });
  if (better == 0) return;
  result.notes.push_back(
      better == 1
          ? fmt::format("A better design was passed over: its links do not lie in {} layers.", max)
          : fmt::format("{} better designs were passed over: their links do not lie in {} layers.",
                        better, max));
}

}  // namespace

std::optional<DriveSpan> motion_span(const Design& design) {
  return drive_span(design.mechanism.mechanism, stations_of(design));
}

std::string_view layers_max_refusal(const Solve& solve) {
  if (solve.certify) {
    return "is given with certify, but what is proved of the error holds for designs of any number "
           "of layers; remove one of them";
  }
  if (solve.robust) {
    return "is given with robust, but those designs are the best for any number of layers; remove "
           "one of them";
  }
  if (solve.objectives.size() > 1) return kNoLayersOfFronts;
  return {};
}

std::string LayeredDesigns::layer(Design& design) const {
  auto layers = layers_of(design, layers_.sizes, deadline_);
  if (!layers) return layers.error();
  std::ranges::move(layer_quantities(*layers), std::back_inserter(design.metrics.quantities));
  design.layers = *std::move(layers);
  return {};
}

void LayeredDesigns::describe(Result& result) const {
  run_.enter(Phase::layers, kUnknownEnd);
  std::vector<std::string> faults(result.designs.size());
  parallel_for(static_cast<int>(faults.size()), run_.threads, [&](int i, int /*thread*/) {
    const auto index = static_cast<std::size_t>(i);
    faults[index] = layer(result.designs[index]);
  });
  for (std::string& fault : faults) add_layer_note(std::move(fault), result);
  const auto blocked = std::ranges::find_if(
      result.designs, [](const Design& design) { return design.layers && !design.layers->count; });
  if (blocked == result.designs.end()) return;
  result.notes.push_back(blocked_design(blocked - result.designs.begin(), *blocked));
}

void LayeredDesigns::check(Design& design, Result& found) {
  add_layer_note(layer(design), found);
  design.constraints.push_back(check_of(design, *layers_.max));
  ++looked_;
}

bool LayeredDesigns::take(Result found) {
  run_.enter(Phase::layers, kUnknownEnd);
  add_work(found.work, work_);
  const bool possible = std::ranges::any_of(found.designs, is_met);
  if (!possible && !best_.designs.empty()) return deadline_.reached();
  std::vector<std::size_t> fitting, passed;
  for (std::size_t i = 0; i < found.designs.size() && fitting.size() < wanted_; ++i) {
    if (!possible && i == wanted_) break;
    Design& design = found.designs[i];
    if (possible && !is_met(design)) continue;
    check(design, found);
    (is_met(design) ? fitting : passed).push_back(i);
  }
  is_final_ = !fitting.empty() || !possible;
  const auto layers = [&](std::size_t i) { return needed(found.designs[i]); };
  if (possible) std::ranges::stable_sort(passed, {}, layers);
  const auto needs_fewer = [&] {
    return best_.designs.empty() || layers(passed.front()) < needed(best_.designs.front());
  };
  if (is_final_ || needs_fewer()) {
    if (!fitting.empty()) note_passed(passed, fitting.front(), *layers_.max, found);
    auto& order = fitting.empty() ? passed : fitting;
    if (order.size() > wanted_) order.resize(wanted_);
    keep(found.designs, order);
    best_ = std::move(found);
  }
  return is_final_ || deadline_.reached();
}

Run LayeredDesigns::round(int round, int rounds) const {
  constexpr std::uint64_t kApart = 0x9e3779b97f4a7c15;
  const double share = 1.0 / rounds;
  run_.enter(Phase::search, (round + 1) * share);
  Run one = part_of(run_, round * share, (round + 1) * share);
  one.seed += kApart * static_cast<std::uint64_t>(round);
  if (run_.time_limit) one.time_limit = std::max(deadline_.remaining(), 0.0);
  return one;
}

void LayeredDesigns::note_none() {
  const Design& first = best_.designs.front();
  if (!first.layers) return;
  auto& notes = best_.notes;
  if (!first.layers->count) {
    notes.push_back(
        fmt::format("No design was found whose links lie in {} layers: of {} looked at none has "
                    "layers at all.",
                    *layers_.max, looked_));
    notes.push_back(blocked_design(0, first));
    return;
  }
  notes.push_back(
      fmt::format("No design was found whose links lie in {} layers: of {} looked at none needs "
                  "fewer than {}.",
                  *layers_.max, looked_, *first.layers->count));
  const std::string collisions = collisions_text(*first.layers, slides(first));
  notes.push_back(
      collisions.empty()
          ? "Joints alone keep design 1 from fewer layers."
          : fmt::format(
                "In addition to its joints these collisions keep design 1 from fewer layers: {}.",
                collisions));
}

Result LayeredDesigns::result() {
  work_.threads = best_.work.threads;
  work_.skipped = best_.work.skipped;
  best_.work = work_;
  if (is_final_ || best_.designs.empty()) return std::move(best_);
  if (deadline_.reached()) {
    best_.status = deadline_.interrupted() ? Status::interrupted : Status::time_limit;
  } else if (best_.status == Status::solved) {
    best_.status = Status::infeasible;
  }
  note_none();
  return std::move(best_);
}

}  // namespace cognate::problems
