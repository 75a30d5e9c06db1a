#include "problems/chain/cosine_scan.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/golden_section.hpp"

namespace cognate::problems {
namespace {

constexpr int kSamples = 180;  ///< of the span, between which extremes are refined
constexpr int kGoldenSteps = 24;
constexpr double kNearLimit = 0.05;  ///< of a cosine: extremes nearer to the limit are watched

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
  return std::isfinite(value) ? value : 2;
}

double CosineScan::peak_near(int joint, double crank, double step) {
  const auto lowered = [&](double at) { return -cosine(joint, at); };
  return golden_section(lowered, crank - step, crank + step, kGoldenSteps).middle();
}

void CosineScan::scan(int joint, const CrankSpan& span, std::vector<TransmissionCheck>& found,
                      double& violation) {
  const double step = (span.to - span.from) / kSamples;
  const bool is_turn = span.to - span.from >= kTurn;
  std::array<double, kSamples + 1> values;
  for (int i = 0; i <= kSamples; ++i) {
    values[static_cast<std::size_t>(i)] = cosine(joint, span.from + step * i);
  }
  for (int i = 0; i <= kSamples; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double here = values[at], before = i > 0 ? values[at - 1] : -1,
                 after = i < kSamples ? values[at + 1] : -1;
    if (here < before || here < after || here < space_.cosine_limit - kNearLimit) continue;
    const bool inner = is_turn || (i > 0 && i < kSamples);
    const double crank =
        inner ? peak_near(joint, span.from + step * i, step) : span.from + step * i;
    found.push_back({joint, crank});
    violation = std::max(
        {violation, here - space_.cosine_limit, cosine(joint, crank) - space_.cosine_limit});
  }
}

}  // namespace cognate::problems
