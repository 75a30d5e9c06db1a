#include "problems/leg/checks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/golden_section.hpp"
#include "problems/chain/cosine_scan.hpp"

namespace cognate::problems {
namespace {

constexpr int kSamples = 180, kGoldenSteps = 24;
constexpr double kInfinite = std::numeric_limits<double>::infinity();
/// Of a speed over its mean: extremes nearer to their limit are watched.
constexpr double kNearSpeed = 0.3;
/// In strides: the foot in swing is watched where it is no higher above the middle of the band.
constexpr double kLowSwing = 0.1;

/// The ends are where the foot leaves a flat path: a small difference of levels moves them far.
constexpr double kEndWeight = 10;

struct Extreme {
  double at, value;
};

/// The least values of `f` over [from, to], each between two samples; those at the ends too.
template <class Function>
std::vector<Extreme> minima(const Function& f, double from, double to) {
  std::array<double, kSamples + 1> values;
  const double step = (to - from) / kSamples;
  for (int i = 0; i <= kSamples; ++i) values[static_cast<std::size_t>(i)] = f(from + step * i);
  std::vector<Extreme> found;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double at = from + step * double(i);
    const bool first = i == 0, last = i + 1 == values.size();
    if (!first && values[i - 1] < values[i]) continue;
    if (!last && values[i + 1] < values[i]) continue;
    if (first || last) {
      found.push_back({at, values[i]});
      continue;
    }
    const auto near = golden_section(f, at - step, at + step, kGoldenSteps);
    const double middle = near.middle();
    found.push_back({middle, f(middle)});
  }
  return found;
}

template <class Function>
Extreme least(const Function& f, double from, double to) {
  const auto all = minima(f, from, to);
  if (all.empty()) return {from, -kInfinite};
  return *std::ranges::min_element(all, {}, &Extreme::value);
}

/// The foot of a leg as functions of the crank.
class Foot {
 public:
  Foot(const LegSpace& space, const LegDesign& leg)
      : space_(space),
        leg_(leg),
        side_(leg.chain.side.begin(), leg.chain.side.end()),
        chain_(space, leg.chain.parameters, side_) {}

  Vec2d at(double crank) { return chain_.at(crank)[space_.foot]; }
  double from() const { return leg_.start; }
  double to() const { return leg_.start + leg_.span; }
  double share(double crank) const { return (crank - leg_.start) / leg_.span; }

  /// Of the points of two lines of one body.
  double distance(int first, int second) {
    const Vec2d* place = chain_.at(from());
    return norm(place[second] - place[first]);
  }

  /// Least and greatest level in stance.
  Range band() {
    const auto low = least([&](double crank) { return at(crank).y; }, from(), to());
    const auto high = least([&](double crank) { return -at(crank).y; }, from(), to());
    return {low.value, -high.value};
  }

  /// Speed over the mean of a stride of 1.
  double speed(double crank, int sense) {
    constexpr double kStep = 1e-3;
    return sense * leg_.span * (at(crank + kStep).x - at(crank - kStep).x) / (2 * kStep);
  }

 private:
  const LegSpace& space_;
  const LegDesign& leg_;
  std::vector<double> side_;
  FreeChain chain_;
};

void check_stride(Foot& foot, LegChecks& checks, double& violation) {
  checks.sense = foot.at(foot.to()).x < foot.at(foot.from()).x ? -1 : 1;
  const auto along = [&](double crank) { return checks.sense * foot.at(crank).x; };
  const auto back = least(along, foot.from(), foot.to());
  const auto ahead = least([&](double crank) { return -along(crank); }, foot.from(), foot.to());
  checks.behind = foot.share(back.at);
  checks.ahead = foot.share(ahead.at);
  violation = std::max(violation, std::abs(-ahead.value - back.value - 1));
}

void check_levels(const LegSpace& space, Foot& foot, LegChecks& checks, double& violation) {
  const Range band = foot.band();
  const double middle = 0.5 * (band.min + band.max);
  const auto level = [&](double crank) { return foot.at(crank).y; };
  const double seam = foot.from() + kTurn;
  violation = std::max(violation, kEndWeight * std::abs(level(foot.from()) - level(foot.to())));
  for (const auto& [at, value] : minima(level, foot.to(), seam)) {
    const bool is_end = at == foot.to() || at == seam;
    if (!is_end && value < middle + kLowSwing) checks.swing.push_back(at);
    violation = std::max(violation, band.min - value);
  }
  const auto bottom = least(level, foot.from(), seam);
  const auto top = least([&](double crank) { return -level(crank); }, foot.from(), seam);
  checks.bottom = bottom.at;
  checks.top = top.at;
  const double height = -top.value - bottom.value;
  if (space.height_min) violation = std::max(violation, *space.height_min - height);
  if (space.height_max) violation = std::max(violation, height - *space.height_max);
  if (!std::isfinite(height)) violation = kInfinite;
}

void check_speeds(const LegSpace& space, Foot& foot, LegChecks& checks, double& violation) {
  const auto check = [&](const std::optional<double>& limit, double sign,
                         std::vector<double>& shares) {
    if (!limit) return;
    const auto speed = [&](double crank) { return sign * foot.speed(crank, checks.sense); };
    for (const auto& [at, value] : minima(speed, foot.from(), foot.to())) {
      const double above = value - sign * *limit;
      if (above < kNearSpeed) shares.push_back(foot.share(at));
      violation = std::max(violation, -above);
    }
  };
  const LegConstraints& limits = space.problem->constraints;
  check(limits.foot_speed_min, 1, checks.slow);
  check(limits.foot_speed_max, -1, checks.fast);
}

void check_distances(const LegSpace& space, Foot& foot, double& violation) {
  for (const DistanceLimit& limit : space.distances) {
    const double distance = foot.distance(limit.from, limit.to);
    violation = std::max({violation, limit.least - distance, distance - limit.most});
  }
}

}  // namespace

LegChecks leg_checks(const LegSpace& space, const LegDesign& design, double& violation) {
  LegChecks checks;
  checks.transmission = CosineScan(space, design.chain).extremes({0, kTurn}, violation);
  Foot foot(space, design);
  check_stride(foot, checks, violation);
  check_levels(space, foot, checks, violation);
  check_speeds(space, foot, checks, violation);
  check_distances(space, foot, violation);
  if (!std::isfinite(violation)) violation = kInfinite;
  return checks;
}

double half_band(const LegSpace& space, const LegDesign& design) {
  const Range band = Foot(space, design).band();
  return 0.5 * (band.max - band.min);
}

}  // namespace cognate::problems
