#include "problems/machine/load_travel.hpp"

#include <cmath>
#include <cstddef>
#include <numeric>

#include "analysis/mechanism/output_limits.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/mechanism/drive_angle.hpp"

namespace cognate::problems {

LoadTravel::LoadTravel(const Mechanism<double>& mechanism, const AssemblyRanges& assembly_ranges,
                       int body)
    : travel_(travels(mechanism)[static_cast<std::size_t>(body)]) {
  if (travel_.slides) return;
  const auto range = output_range(mechanism, assembly_ranges, travel_);
  constexpr double kWhole = kTurn - 1e-6;
  if (!range || range->stroke() >= kWhole) return;
  swings_ = true;
  least_ = range->least.value;
  middle_ = std::midpoint(least_, range->greatest.value);
}

double LoadTravel::travelled(std::span<const BodyMotion<double, 2>> bodies) const {
  const double at = cognate::travelled<2>(travel_, bodies);
  if (travel_.slides) return at;
  if (!swings_) return in_one_turn(at);
  return middle_ - least_ + std::remainder(at - middle_, kTurn);
}

double LoadTravel::rate(std::span<const BodyMotion<double, 2>> bodies) const {
  return travel_rate<2>(travel_, bodies);
}

}  // namespace cognate::problems
