#include "problems/chain/cosine_scan.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace cognate::problems {
namespace {

constexpr int kSamples = 180;        ///< of the span, between which extremes are refined
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

void CosineScan::scan(int joint, const CrankSpan& span, std::vector<TransmissionCheck>& found,
                      double& violation) {
  const double step = (span.to - span.from) / kSamples;
  std::array<double, kSamples + 1> values;
  for (int i = 0; i <= kSamples; ++i) {
    values[static_cast<std::size_t>(i)] = cosine(joint, span.from + step * i);
  }
  for (int i = 0; i <= kSamples; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double here = values[at], before = i > 0 ? values[at - 1] : -1,
                 after = i < kSamples ? values[at + 1] : -1;
    if (here < before || here < after || here < space_.cosine_limit - kNearLimit) continue;
    const bool inner = i > 0 && i < kSamples;
    const double bend = before - 2 * here + after;
    const double shift =
        inner && bend < 0 ? std::clamp(0.5 * (before - after) / bend, -1.0, 1.0) : 0;
    const double crank = span.from + step * (i + shift);
    found.push_back({joint, crank});
    violation = std::max(
        {violation, here - space_.cosine_limit, cosine(joint, crank) - space_.cosine_limit});
  }
}

}  // namespace cognate::problems
