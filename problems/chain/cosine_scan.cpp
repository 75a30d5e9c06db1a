#include "problems/chain/cosine_scan.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/numbers/constants.hpp"

namespace cognate::problems {
namespace {

constexpr int kSamples = 180;        ///< of the span, between which extremes are refined
constexpr double kFiner = 16;        ///< parabolas are laid through points ever so much nearer
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
  synthesis::place(view, unit_vector(crank), place_);
  const double value = std::abs(synthesis::transmission_cosine(view, place_, joint));
  return std::isfinite(value) ? value : 2;
}

double CosineScan::peak_near(int joint, double crank, double step) {
  double at = crank;
  for (const double reach : {step, step / kFiner, step / (kFiner * kFiner)}) {
    const double before = cosine(joint, at - reach), here = cosine(joint, at),
                 after = cosine(joint, at + reach);
    const double bend = before - 2 * here + after;
    if (bend < 0) at += reach * std::clamp(0.5 * (before - after) / bend, -1.0, 1.0);
  }
  return at;
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
