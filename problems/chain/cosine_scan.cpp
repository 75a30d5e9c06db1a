#include "problems/chain/cosine_scan.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/golden_section.hpp"

namespace cognate::problems {
namespace {

constexpr int kGoldenSteps = 24;
constexpr double kNearLimit = 0.05;  ///< of a cosine: extremes nearer to the limit are watched
constexpr double kOpen = 2;          ///< in the place of a cosine where the chain does not close

}  // namespace

std::vector<TransmissionCheck> CosineScan::extremes(const CrankSpan& span, double& violation) {
  std::vector<TransmissionCheck> found;
  violation = 0;
  for (const int joint : space_.joints) scan(joint, span, found, violation);
  return found;
}

double CosineScan::cosine(int joint, double crank) {
  const synthesis::ChainView<double> view{space_.lines.data(),
                                          static_cast<int>(space_.lines.size()),
                                          design_.parameters.data(), side_.data()};
  synthesis::place_next(view, unit_vector(crank), place_);
  const double value = std::abs(synthesis::transmission_cosine(view, place_, joint));
  return std::isfinite(value) ? value : kOpen;
}

double CosineScan::peak_near(int joint, double crank, double step) {
  const auto lowered = [&](double at) { return -cosine(joint, at); };
  return golden_section(lowered, crank - step, crank + step, kGoldenSteps).middle();
}

auto CosineScan::sampled(int joint, const CrankSpan& span) -> Samples {
  const double step = (span.to - span.from) / kSamples;
  Samples values;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double crank = span.from + step * double(i);
    // From a dead point on a three-pin link is led nowhere, until it begins anew at angle 0.
    const bool is_beyond = is_led_ && i > 0 && values[i - 1] == kOpen &&
                           in_one_turn(crank) > in_one_turn(crank - step);
    values[i] = is_beyond ? kOpen : cosine(joint, crank);
  }
  return values;
}

void CosineScan::scan(int joint, const CrankSpan& span, std::vector<TransmissionCheck>& found,
                      double& violation) {
  const double step = (span.to - span.from) / kSamples;
  const bool is_turn = span.to - span.from >= kTurn;
  const auto values = sampled(joint, span);
  // Of what is led the way to a dead point is watched, not what is beyond.
  const auto is_open = [&](double value) { return is_led_ && value == kOpen; };
  for (int i = 0; i <= kSamples; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double here = values[at], before = i > 0 ? values[at - 1] : -1,
                 after = i < kSamples ? values[at + 1] : -1;
    const bool at_dead_point = is_open(before) || is_open(after);
    if (is_open(here)) violation = std::max(violation, here - space_.cosine_limit);
    const bool is_extreme = at_dead_point || (here >= before && here >= after);
    if (is_open(here) || !is_extreme || here < space_.cosine_limit - kNearLimit) continue;
    const bool inner = (is_turn || (i > 0 && i < kSamples)) && !at_dead_point;
    const double crank =
        inner ? peak_near(joint, span.from + step * i, step) : span.from + step * i;
    found.push_back({joint, crank});
    violation = std::max(
        {violation, here - space_.cosine_limit, cosine(joint, crank) - space_.cosine_limit});
  }
}

}  // namespace cognate::problems
