#include "problems/chain/crank_angles/starts.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/constants.hpp"

namespace cognate::problems {

std::vector<DriveRange> starts_within_ranges(const Mechanism<double>& mechanism, double least,
                                             double greatest) {
  std::vector<DriveRange> starts;
  for (const DriveRange& range : ranges_over_a_turn(mechanism)) {
    if (is_whole_turn(range)) return {range};
    const DriveRange within{range.from - least, range.to - greatest};
    if (within.from <= within.to) starts.push_back(within);
  }
  return starts;
}

std::vector<std::vector<double>> first_phases(const ScaledChain& problem,
                                              const synthesis::ChainDesign& design, int per_turn) {
  const NamedMechanism mechanism = named(*problem.topology, design);
  const auto [least, greatest] = std::ranges::minmax(problem.crank_angles);
  std::vector<std::vector<double>> all;
  for (const DriveRange& phases : starts_within_ranges(mechanism.mechanism, least, greatest)) {
    for (const double phase : spread_over(phases, per_turn)) all.push_back({phase});
  }
  return all;
}

bool is_whole_turn(const DriveRange& starts) {
  return starts.to - starts.from >= kTurn * (1 - 1e-12);
}

std::vector<double> spread_over(const DriveRange& starts, int per_turn) {
  constexpr int kFewest = 8;
  const double width = starts.to - starts.from;
  const int count = std::max(kFewest, static_cast<int>(std::ceil(per_turn * width / kTurn)));
  std::vector<double> places;
  for (int i = 0; i < count; ++i) places.push_back(starts.from + width * (i + 0.5) / count);
  return places;
}

}  // namespace cognate::problems
