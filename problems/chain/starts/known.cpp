#include "problems/chain/starts/known.hpp"

#include <algorithm>
#include <numeric>
#include <string>

#include "analysis/numbers/angle.hpp"
#include "problems/basics/quantity_key.hpp"
#include "problems/chain/starts/heading.hpp"

namespace cognate::problems {
namespace {

/// Radians by which angles in order may seem to step back.
constexpr double kStepBack = 1e-6;

/// Angles of one turn, which stand for themselves plus whole turns, as they follow each other
/// counter-clockwise (`sense` 1) or clockwise (−1).
std::vector<double> in_sense(const std::vector<double>& angles, double sense) {
  std::vector<double> all{angles.front()};
  for (std::size_t i = 1; i < angles.size(); ++i) {
    const double step = in_one_turn(sense * (angles[i] - angles[i - 1]) + kStepBack) - kStepBack;
    all.push_back(all.back() + sense * step);
  }
  return all;
}

/// In the sense in which they take the shorter way.
std::vector<double> unrolled(const std::vector<double>& angles) {
  auto forward = in_sense(angles, 1), backward = in_sense(angles, -1);
  const auto way = [](const std::vector<double>& all) {
    return std::abs(all.back() - all.front());
  };
  return way(forward) <= way(backward) ? forward : backward;
}

/// The line of the body's heading, which mechanisms do not have.
void add_heading(synthesis::ChainDesign& design) {
  design.parameters.push_back(0);
  design.side.push_back(0);
}

std::vector<std::size_t> all_of(const std::vector<double>& angles) {
  std::vector<std::size_t> all(angles.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

}  // namespace

std::vector<ChainMinimum> known_starts(const std::vector<Design>& known,
                                       const std::vector<ScaledChain>& chains,
                                       const TargetScale& scale) {
  std::vector<ChainMinimum> starts;
  for (const Design& design : known) {
    const auto name =
        find_quantity(design.metrics.quantities, QuantityKey<std::string>{"topology"});
    const auto chain = std::ranges::find(chains, name.value_or(""),
                                         [](const ScaledChain& one) { return one.topology->name; });
    if (chain == chains.end() || design.crank_angles.size() != chain->points.size()) continue;
    std::vector<double> angles = unrolled(design.crank_angles);
    auto dimensions_known = dimensions(*chain->topology, design.mechanism);
    if (chain->is_motion()) add_heading(dimensions_known);
    auto start = within_bounds(*chain, scale.into(chain->chain, dimensions_known));
    if (chain->is_motion()) turn_body(*chain, all_of(angles), angles, start);
    if (chain->timed()) angles = {angles.front() - chain->crank_angles.front()};
    starts.push_back(
        {&*chain, std::move(start), std::move(angles), design.error.rms / scale.size, 0});
  }
  return starts;
}

}  // namespace cognate::problems
