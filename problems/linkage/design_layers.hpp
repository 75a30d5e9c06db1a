/// @file The layers of designs that a synthesis found, and the search for designs that need few.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "problems/layers/layers.hpp"
#include "problems/linkage/drive_span.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// Whether further starts may lead to further designs.
enum class DesignSource { exact, search };

/// The part of its drive over which a design is drawn and layered: see drive_span.hpp.
std::optional<DriveSpan> motion_span(const Design& design);

/// Why a front takes no `layers_max`.
inline constexpr std::string_view kNoLayersOfFronts =
    "is given with two objectives, but the designs of a front are the best for any number of "
    "layers; expected one objective, or none";

/// Why a problem so solved takes no `layers_max`; empty where it does.
std::string_view layers_max_refusal(const Solve& solve);

/// Designs in the order of a search, of which those that fit into the layers allowed are kept.
class LayeredDesigns {
 public:
  LayeredDesigns(const DesignLayers& layers, int designs, const Run& run)
      : layers_(layers), wanted_(static_cast<std::size_t>(designs)), run_(run), deadline_(run) {}

  /// The layers of every design of `result`, and notes on the best.
  void describe(Result& result) const;

  /// Takes what a search found, the best first, and has the layers of as many as must be known:
  /// until there are as many as wanted that fit. Returns whether a further search is of no use:
  /// a design fits, none meets the other limits, or the time is up.
  bool take(Result found);

  /// How search number `round`, counted from 0, of at most `rounds` is run.
  Run round(int round, int rounds) const;

  /// The designs that fit, or without such those that need the fewest layers, with what kept others
  /// out.
  Result result();

 private:
  /// Sets the layers of a design; returns why it has none.
  std::string layer(Design& design) const;
  void check(Design& design, Result& found);
  void note_none();

  const DesignLayers& layers_;
  std::size_t wanted_;
  const Run& run_;
  Deadline deadline_;
  Result best_;             ///< of the searches so far
  Work work_;               ///< of all of them
  bool is_final_ = false;   ///< whether `best_` has designs that fit, or cannot have any
  std::size_t looked_ = 0;  ///< designs whose layers were looked at
};

/// What `solve_once(problem, run)` finds, with the layers of its designs where the problem has
/// layers.
///
/// With a limit of them the search is asked for more designs, and those that need more layers are
/// passed over. While none fits, a search is repeated with other starts, three times at most: the
/// number of layers is no function that a search could follow, so that the designs that it passes
/// over are local optima of the error, and that none fits is no proof.
template <class AnyProblem, class SolveOnce>
Result solve_in_layers(const AnyProblem& problem, const Run& run, DesignSource source,
                       const SolveOnce& solve_once) {
  constexpr int kCandidates = 24, kMoreCandidates = 100, kRounds = 4;
  if (!problem.layers) return solve_once(problem, run);
  LayeredDesigns designs(*problem.layers, problem.solve.designs, run);
  if (!problem.layers->max) {
    Result result = solve_once(problem, run);
    designs.describe(result);
    return result;
  }
  AnyProblem wider = problem;
  const int rounds = source == DesignSource::search ? kRounds : 1;
  for (int round = 0; round < rounds; ++round) {
    const int candidates = round == 0 && rounds > 1 ? kCandidates : kMoreCandidates;
    wider.solve.designs = std::max(problem.solve.designs, candidates);
    if (designs.take(solve_once(wider, designs.round(round, rounds)))) break;
  }
  return designs.result();
}

}  // namespace cognate::problems
