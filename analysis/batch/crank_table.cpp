#include "analysis/batch/crank_table.hpp"

#include <algorithm>
#include <numeric>

#include "analysis/linkage/closure.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate {
namespace {

/// Runs shorter than this on average are not worth their ends.
constexpr std::size_t kShortRun = batch::kPadding;

std::vector<batch::Run> runs_of(const std::vector<CrankDirection<double>>& directions,
                                const std::vector<std::size_t>& order) {
  std::vector<batch::Run> runs;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const int side = directions[order[i]].side;
    if (runs.empty() || runs.back().side != side) runs.push_back({i, i, side});
    runs.back().end = i + 1;
  }
  return runs;
}

}  // namespace

template <class Real>
CrankTable<Real>::CrankTable(std::span<const double> angles, double origin)
    : sin_(angles.size() + batch::kPadding),
      versine_(angles.size() + batch::kPadding),
      order_(angles.size()) {
  std::vector<CrankDirection<double>> directions;
  directions.reserve(angles.size());
  for (const double angle : angles) directions.push_back(crank_direction(angle - origin));
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  runs_ = runs_of(directions, order_);
  if (runs_.size() > 2 && runs_.size() * kShortRun > angles.size()) {
    std::stable_partition(order_.begin(), order_.end(),
                          [&](std::size_t row) { return directions[row].side > 0; });
    in_order_ = std::is_sorted(order_.begin(), order_.end());
    runs_ = runs_of(directions, order_);
  }
  for (std::size_t i = 0; i < order_.size(); ++i) {
    sin_[i] = static_cast<Real>(directions[order_[i]].sin);
    versine_[i] = static_cast<Real>(directions[order_[i]].versine);
  }
}

template <class Real>
CrankTable<Real> CrankTable<Real>::full_turn(std::size_t count) {
  std::vector<double> angles(count);
  for (std::size_t i = 0; i < count; ++i) {
    angles[i] = kTurn * static_cast<double>(i) / static_cast<double>(count);
  }
  return CrankTable(angles);
}

template class CrankTable<double>;
template class CrankTable<float>;

}  // namespace cognate
