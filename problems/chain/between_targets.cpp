#include "problems/chain/between_targets.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "synthesis/chain/sweep.hpp"

namespace cognate::problems {
namespace {

constexpr double kPlaces[] = {0.25, 0.5, 0.75};  ///< between two crank angles
/// Of the longest of a way and those beside it, by so much of which a curve may leave the way:
/// where it turns sharply, the way is short.
constexpr double kBulge = 0.5;

/// The traced point of a design.
class TracedPoint {
 public:
  TracedPoint(const ScaledChain& problem, const synthesis::ChainDesign& design)
      : problem_(problem), design_(design), side_(design.side.begin(), design.side.end()) {}

  Vec2d at(double crank) {
    const synthesis::ChainView<double> view{problem_.lines.data(),
                                            static_cast<int>(problem_.lines.size()),
                                            design_.parameters.data(), side_.data()};
    synthesis::place_next(view, unit_vector(crank), place_);
    return place_.at[problem_.topology->trace];
  }

 private:
  const ScaledChain& problem_;
  const synthesis::ChainDesign& design_;
  std::vector<double> side_;
  synthesis::ChainPlace<double> place_;
};

double distance_to_segment(const Vec2d& point, const Vec2d& from, const Vec2d& to) {
  const Vec2d way = to - from, offset = point - from;
  const double square = squared_norm(way);
  const double share = square > 0 ? std::clamp(dot(offset, way) / square, 0.0, 1.0) : 0;
  return norm(offset - share * way);
}

std::vector<double> ways_between(std::span<const Vec2d> targets, bool closed) {
  std::vector<double> ways;
  for (std::size_t i = 1; i < targets.size(); ++i)
    ways.push_back(norm(targets[i] - targets[i - 1]));
  if (closed) ways.push_back(norm(targets.front() - targets.back()));
  return ways;
}

/// The longest of a way, that before and that after it.
double longest_beside(const std::vector<double>& ways, std::size_t i, bool closed) {
  const std::size_t last = ways.size() - 1;
  const std::size_t before = i > 0 ? i - 1 : (closed ? last : 0);
  const std::size_t after = i < last ? i + 1 : (closed ? 0 : last);
  return std::max({ways[before], ways[i], ways[after]});
}

}  // namespace

double squared_stray(const ScaledChain& problem, const synthesis::ChainDesign& design,
                     std::span<const Vec2d> targets, std::span<const double> angles) {
  if (problem.timed() || problem.is_motion()) return 0;
  TracedPoint traced(problem, design);
  const double turn = angles.back() > angles.front() ? kTurn : -kTurn;
  const auto ways = ways_between(targets, problem.closed);
  std::vector<double> missed;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    missed.push_back(norm(traced.at(angles[i]) - targets[i]));
  }
  double sum = 0;
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const bool is_last = i + 1 == targets.size();
    const std::size_t next = is_last ? 0 : i + 1;
    const Vec2d &from = targets[i], &to = targets[next];
    const double begin = angles[i], end = is_last ? angles.front() + turn : angles[next];
    const double free =
        kBulge * longest_beside(ways, i, problem.closed) + std::max(missed[i], missed[next]);
    for (const double share : kPlaces) {
      const Vec2d point = traced.at(begin + share * (end - begin));
      const double beyond = distance_to_segment(point, from, to) - free;
      if (std::isnan(beyond)) return kInfinity;
      sum += beyond > 0 ? beyond * beyond : 0;
    }
  }
  return sum / double(std::size(kPlaces) * ways.size());
}

}  // namespace cognate::problems
