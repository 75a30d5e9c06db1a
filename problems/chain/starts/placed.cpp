#include "problems/chain/starts/placed.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "synthesis/chain/transform.hpp"

namespace cognate::problems {
namespace {

using synthesis::LineType;

constexpr std::size_t kMoved = 6;  ///< designs that are placed
constexpr int kSizes = 6;          ///< where the crank's length is open
constexpr int kDirections = 24;

/// What the file gives of a parameter, or the middle of its bounds.
double middle(const ScaledChain& scaled, std::size_t parameter) {
  return scaled.given[parameter].value_or(0.5 *
                                          (scaled.lower[parameter] + scaled.upper[parameter]));
}

const synthesis::PlacedLine& crank_line(const ScaledChain& scaled) {
  return *std::ranges::find_if(scaled.lines, [](const synthesis::PlacedLine& line) {
    return line.line.type == LineType::crank;
  });
}

std::vector<double> crank_lengths(const ScaledChain& scaled, std::size_t parameter) {
  if (scaled.given[parameter]) return {*scaled.given[parameter]};
  std::vector<double> lengths;
  for (int i = 0; i < kSizes; ++i) {
    const double share = (i + 0.5) / kSizes;
    lengths.push_back(scaled.lower[parameter] *
                      std::pow(scaled.upper[parameter] / scaled.lower[parameter], share));
  }
  return lengths;
}

/// p → place + turn·(p − from).
struct Move {
  Vec2d turn, from, place;
};

PlacedChain moved(const ScaledChain& scaled, const ChainMinimum& found, const Move& move) {
  PlacedChain made{found.design, found.angles, {}};
  auto& parameters = made.design.parameters;
  synthesis::transform(scaled.lines, move.turn, move.place - move.turn * move.from, parameters);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    parameters[i] =
        scaled.given[i].value_or(std::clamp(parameters[i], scaled.lower[i], scaled.upper[i]));
  }
  for (double& angle : made.angles) angle += std::atan2(move.turn.y, move.turn.x);
  made.at.turn = (1 / squared_norm(move.turn)) * conj(move.turn);
  made.at.shift = move.from - made.at.turn * move.place;
  return made;
}

}  // namespace

ChainPathProblem without_sizes(const ChainPathProblem& problem) {
  ChainPathProblem free = problem;
  free.is_movable = false;
  for (Topology& topology : free.topologies) {
    for (TopologyLine& line : topology.lines) {
      line.given = {};
      line.bounds = TopologyLine{}.bounds;
    }
  }
  return free;
}

std::vector<PlacedChain> placed_starts(const ScaledChain& scaled,
                                       std::span<const ChainMinimum> found) {
  std::vector<PlacedChain> starts;
  const auto& [crank, place] = crank_line(scaled);
  const auto length = static_cast<std::size_t>(place);
  const auto pivot =
      static_cast<std::size_t>(scaled.lines[static_cast<std::size_t>(crank.first)].parameter);
  const Vec2d centre{middle(scaled, pivot), middle(scaled, pivot + 1)};
  for (const ChainMinimum& one : found.first(std::min(found.size(), kMoved))) {
    const auto& own = one.design.parameters;
    for (const double wanted : crank_lengths(scaled, length)) {
      for (int k = 0; k < kDirections; ++k) {
        const Vec2d turn = (wanted / own[length]) * unit_vector(kTurn * k / kDirections);
        starts.push_back(moved(scaled, one, {turn, {own[pivot], own[pivot + 1]}, centre}));
      }
    }
  }
  return starts;
}

}  // namespace cognate::problems
