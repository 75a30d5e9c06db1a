#include "problems/function/screen.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/numbers/constants.hpp"
#include "problems/function/dead_centre.hpp"
#include "problems/function/length_ranges.hpp"
#include "problems/linkage/linkage_constraints.hpp"
#include "synthesis/lanes/function_fit.hpp"

namespace cognate::problems {
namespace {

using synthesis::FunctionCandidates;

/// The least and greatest cosine of the angles from `from` to `to`.
Range cosines(double from, double to) {
  const double top = std::ceil(from / kTurn) * kTurn;
  const double bottom = std::ceil((from - kPi) / kTurn) * kTurn + kPi;
  const auto [least, greatest] = std::minmax({std::cos(from), std::cos(to)});
  return {bottom <= to ? -1 : least, top <= to ? 1 : greatest};
}

FunctionCandidates candidates_of(const std::vector<FunctionGenerator>& all) {
  constexpr std::size_t lanes = FunctionCandidates::lanes;
  FunctionCandidates candidates((all.size() + lanes - 1) / lanes * lanes);
  for (std::size_t i = 0; i < candidates.crank.size(); ++i) {
    const FunctionGenerator& g = all[std::min(i, all.size() - 1)];
    candidates.crank[i] = g.links.crank;
    candidates.coupler[i] = g.links.coupler;
    candidates.rocker[i] = g.links.rocker;
    candidates.frame[i] = g.links.frame;
    candidates.half_start_x[i] = std::cos(0.5 * g.input_start);
    candidates.half_start_y[i] = std::sin(0.5 * g.input_start);
    candidates.output_start_x[i] = std::cos(g.output_start);
    candidates.output_start_y[i] = std::sin(g.output_start);
  }
  return candidates;
}

}  // namespace

FunctionScreen::FunctionScreen(const FunctionProblem& problem,
                               std::vector<synthesis::AnglePair> wanted)
    : problem_(problem), wanted_(std::move(wanted)), ranges_(length_ranges(problem)) {
  for (const synthesis::AnglePair& pair : wanted_) {
    sweep_.min = std::min(sweep_.min, pair.input);
    sweep_.max = std::max(sweep_.max, pair.input);
  }
}

/// cos μ grows with the cosine of the crank's angle. Of a crank that turns fully the limit is that
/// of the turn, as `confining_class` has it.
double FunctionScreen::penalty(const FunctionGenerator& generator) const {
  const auto& limit = problem_.constraints.transmission_angle;
  if (!limit) return 0;
  const auto& [l1, l2, l3, l4] = generator.links;
  const auto confined_to = confining_class(problem_.constraints, generator.links);
  const bool turns =
      confined_to == RequiredClass::crank_rocker || confined_to == RequiredClass::double_crank;
  const Range crank =
      turns ? Range{-1, 1}
            : cosines(generator.input_start + sweep_.min, generator.input_start + sweep_.max);
  const auto cosine = [&](double of_crank) {
    return (l2 * l2 + l3 * l3 - l1 * l1 - l4 * l4 + 2 * l1 * l4 * of_crank) / (2 * l2 * l3);
  };
  const double above = cosine(crank.max) - std::cos(limit->min);
  const double below = std::cos(limit->max) - cosine(crank.min);
  const double violation = kPenalty * std::max({above, below, 0.0});
  return violation * violation;
}

std::vector<Assembly> FunctionScreen::assemblies() const {
  if (problem_.given.assembly) return {*problem_.given.assembly};
  return {Assembly::open, Assembly::crossed};
}

Lengths<double> FunctionScreen::scaled(const Lengths<double>& links) const {
  const std::array values{links.crank, links.coupler, links.rocker, links.frame};
  double factor = std::sqrt(ranges_[0].min * ranges_[0].max) / links.crank;
  for (const int i : {2, 1, 3, 0}) {
    if (fixed(i)) factor = ranges_[i].min / values[i];
  }
  const auto within = [&](int i) {
    return std::clamp(factor * values[i], ranges_[i].min, ranges_[i].max);
  };
  return {within(0), within(1), within(2), within(3)};
}

double FunctionScreen::clamped_start(double angle, const std::optional<Range>& bounds) const {
  if (!bounds) return angle;
  const double middle = 0.5 * (bounds->min + bounds->max);
  return std::clamp(middle + wrapped(angle - middle), bounds->min, bounds->max);
}

std::vector<FunctionGenerator> FunctionScreen::started(FunctionGenerator generator) const {
  if (starts_free()) {
    generator.input_start = clamped_start(generator.input_start, problem_.input_start_bounds);
    generator.output_start = problem_.output_start.value_or(0);
    return {generator};
  }
  std::vector<FunctionGenerator> all;
  for (const Assembly assembly : assemblies()) {
    const auto dead = dead_centre(generator.links, assembly, problem_.start);
    if (dead) all.push_back({generator.links, assembly, dead->crank_angle, dead->rocker_angle});
  }
  return all;
}

std::vector<FunctionStartPoint> FunctionScreen::screened(
    const std::vector<FunctionGenerator>& all) const {
  std::vector<FunctionStartPoint> points;
  if (all.empty()) return points;
  FunctionCandidates candidates = candidates_of(all);
  const bool given = !starts_free() || problem_.output_start;
  synthesis::screen(wanted_, given ? synthesis::OutputStart::given : synthesis::OutputStart::best,
                    candidates);
  for (std::size_t i = 0; i < all.size(); ++i) {
    FunctionStartPoint& best = points.emplace_back(FunctionStartPoint{all[i], kInfinity});
    for (const Assembly assembly : assemblies()) {
      if (!starts_free() && assembly != all[i].assembly) continue;
      const double error = assembly == Assembly::open ? candidates.open[i] : candidates.crossed[i];
      if (!(error < best.error)) continue;
      best.error = error;
      best.generator.assembly = assembly;
    }
    best.error += penalty(best.generator);
  }
  return points;
}

FunctionStartPoint FunctionScreen::scored(FunctionGenerator g) const {
  const FunctionStartPoint nothing{g, kInfinity};
  if (!starts_free()) {
    const auto dead = dead_centre(g.links, g.assembly, problem_.start);
    if (!dead) return nothing;
    g.input_start = dead->crank_angle;
    g.output_start = dead->rocker_angle;
  } else {
    g.input_start = clamped_start(g.input_start, problem_.input_start_bounds);
    const auto start =
        problem_.output_start ? problem_.output_start : best_output_start(g, wanted_);
    if (!start) return nothing;
    g.output_start = problem_.output_start ? *problem_.output_start
                                           : clamped_start(*start, problem_.output_start_bounds);
  }
  const double sum = StructuralError(g).sum_of_squares(wanted_);
  return {g, sum / static_cast<double>(wanted_.size()) + penalty(g)};
}

FunctionStartPoint FunctionScreen::best_assembly(FunctionGenerator g) const {
  FunctionStartPoint best{g, kInfinity};
  for (const Assembly assembly : assemblies()) {
    g.assembly = assembly;
    const FunctionStartPoint point = scored(g);
    if (point.error < best.error) best = point;
  }
  return best;
}

}  // namespace cognate::problems
