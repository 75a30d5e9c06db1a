#include "problems/path/starts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/random.hpp"
#include "problems/linkage/link_ratios.hpp"

namespace cognate::problems {
namespace {

using synthesis::PathCandidates;
using synthesis::SeparableTarget;

/// Of the logarithms of proportions, and of phases, about those of a known design.
constexpr double kLeastSpread = 0.01, kMostSpread = 1;

double least(const std::optional<double>& given, const std::optional<Range>& bounds) {
  if (given) return *given;
  return bounds ? bounds->min : 0;
}

double greatest(const std::optional<double>& given, const std::optional<Range>& bounds) {
  if (given) return *given;
  return bounds ? bounds->max : std::numeric_limits<double>::infinity();
}

/// The largest ratio of two links worth drawing: what the bounds allow, at most 300.
double largest_ratio(const Given& given, const Bounds& bounds) {
  const double low =
      std::min({least(given.crank, bounds.crank), least(given.coupler, bounds.coupler),
                least(given.rocker, bounds.rocker), least(given.frame, bounds.frame)});
  const double high =
      std::max({greatest(given.crank, bounds.crank), greatest(given.coupler, bounds.coupler),
                greatest(given.rocker, bounds.rocker), greatest(given.frame, bounds.frame)});
  return std::min(300.0, high / low);
}

/// `drawn` enlarged by what suits most of its lengths and each brought into its range, then
/// enlarged again to crank = 1.
Lengths<double> proportioned(std::mt19937_64& random, const Lengths<double>& drawn,
                             const std::array<Range, 4>& ranges) {
  std::array<double, 4> links{drawn.crank, drawn.coupler, drawn.rocker, drawn.frame};
  double least = 0, greatest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < links.size(); ++i) {
    least = std::max(least, ranges[i].min / links[i]);
    greatest = std::min(greatest, ranges[i].max / links[i]);
  }
  // Where a side is open there is nothing to be found between.
  if (least == 0) least = greatest;
  if (std::isinf(greatest)) greatest = least;
  const double scale = least * std::pow(greatest / least, uniform(random, 0, 1));
  for (std::size_t i = 0; i < links.size(); ++i) {
    links[i] = std::clamp(scale * links[i], ranges[i].min, ranges[i].max);
  }
  return {1, links[1] / links[0], links[2] / links[0], links[3] / links[0]};
}

}  // namespace

PathStarts::PathStarts(const PathProblem& scaled) : problem_(scaled) {
  const std::size_t n = problem_.points.size();
  weight_ = problem_.weights;
  weight_.resize(n, 1.0);
  if (problem_.given.pivot_a) {
    origin_ = *problem_.given.pivot_a;
  } else {
    const double total = std::accumulate(weight_.begin(), weight_.end(), 0.0);
    for (std::size_t j = 0; j < n; ++j) {
      origin_ = origin_ + (weight_[j] / total) * problem_.points[j];
    }
  }
  for (std::size_t j = 0; j < n; ++j) {
    const Vec2d relative = problem_.points[j] - origin_;
    x_.push_back(relative.x);
    y_.push_back(relative.y);
  }
  largest_ratio_ = largest_ratio(problem_.given, problem_.bounds);
  const bool any_timed = problem_.timing != Timing::free;
  while (any_timed && !problem_.is_timed(first_timed_)) ++first_timed_;
}

void PathStarts::set_limits(SeparableTarget& target) const {
  const Given& given = problem_.given;
  const Bounds& bounds = problem_.bounds;
  const auto set = [&](int k, const auto& value, const auto& range) {
    target.least[k] = least(value, range);
    target.greatest[k] = greatest(value, range);
  };
  set(0, given.crank, bounds.crank);
  set(1, given.coupler, bounds.coupler);
  set(2, given.rocker, bounds.rocker);
  set(3, given.frame, bounds.frame);
}

void PathStarts::set_direction(SeparableTarget& target) const {
  const bool global =
      problem_.timing != Timing::free && problem_.crank_reference == CrankReference::global;
  if (problem_.given.frame_angle) {
    target.direction = SeparableTarget::Direction::fixed;
    target.direction_cos = std::cos(*problem_.given.frame_angle);
    target.direction_sin = std::sin(*problem_.given.frame_angle);
  } else if (global) {
    target.direction = SeparableTarget::Direction::minus_phase;
  }
}

std::optional<double> PathStarts::fixed_phase() const {
  if (problem_.timing == Timing::free) return std::nullopt;
  switch (problem_.crank_reference) {
    case CrankReference::first:
      return std::nullopt;
    case CrankReference::frame:
      return 0.0;
    case CrankReference::global:
      if (problem_.given.frame_angle) return -*problem_.given.frame_angle;
  }
  return std::nullopt;
}

/// Lengths with crank = 1.
Lengths<double> PathStarts::random_links(std::mt19937_64& random) const {
  const Constraints& constraints = problem_.constraints;
  auto required = constraints.required_class;
  if (constraints.full_turn && (!required || *required == RequiredClass::grashof)) {
    required = random() % 2 ? RequiredClass::crank_rocker : RequiredClass::double_crank;
  }
  const Lengths<double> drawn = random_ratios(random, required, largest_ratio_);
  return constraints.proportions ? proportioned(random, drawn, *constraints.proportions) : drawn;
}

void PathStarts::fill(std::mt19937_64& random, PathCandidates& candidates) const {
  const auto phase = fixed_phase();
  for (std::size_t i = 0; i < candidates.coupler.size(); ++i) {
    const Lengths<double> ratios = random_links(random);
    candidates.coupler[i] = ratios.coupler;
    candidates.rocker[i] = ratios.rocker;
    candidates.frame[i] = ratios.frame;
    const double half = 0.5 * (phase ? *phase : uniform(random, 0, kTurn));
    candidates.phase_cos[i] = std::cos(half);
    candidates.phase_sin[i] = std::sin(half);
  }
}

/// Proportions and phases about those of a design, some near it, some far away: what lies in the
/// next basins is seldom drawn by chance where basins are small.
void PathStarts::fill_about(std::mt19937_64& random, const KnownPath& known,
                            PathCandidates& candidates) const {
  for (std::size_t i = 0; i < candidates.coupler.size(); ++i) {
    const double spread =
        kLeastSpread * std::pow(kMostSpread / kLeastSpread, uniform(random, 0, 1));
    std::normal_distribution<double> disturbance(0, spread);
    const auto ratio = [&](double length) {
      return length / known.links.crank * std::exp(disturbance(random));
    };
    candidates.coupler[i] = ratio(known.links.coupler);
    candidates.rocker[i] = ratio(known.links.rocker);
    candidates.frame[i] = ratio(known.links.frame);
    const double half = 0.5 * (known.phase + disturbance(random));
    candidates.phase_cos[i] = std::cos(half);
    candidates.phase_sin[i] = std::sin(half);
  }
}

PathStart PathStarts::start(const SeparableTarget& target, const CrankTiming& timing,
                            const PathCandidates& candidates, std::size_t best) const {
  const std::size_t i = best / 2;
  const Assembly assembly = best % 2 == 0 ? Assembly::open : Assembly::crossed;
  const Vec2d half{candidates.phase_cos[i], candidates.phase_sin[i]};
  const Lengths<double> ratios{1, candidates.coupler[i], candidates.rocker[i], candidates.frame[i]};
  const auto fit = separable_fit(target, ratios, half, sign(assembly));
  const Vec2d pivot = target.pivot_fixed ? origin_ : origin_ + fit.pivot;
  PathStart start;
  start.error = fit.error;
  start.clockwise = timing.clockwise;
  start.linkage = {.pivot_a = pivot,
                   .pivot_d = pivot + (fit.crank * ratios.frame) * fit.frame_direction,
                   .crank = fit.crank,
                   .coupler = fit.crank * ratios.coupler,
                   .rocker = fit.crank * ratios.rocker,
                   .assembly = assembly,
                   .coupler_point = conj(fit.frame_direction) * fit.coupler_point};
  const double offset = 2 * std::atan2(half.y, half.x) + frame_angle(start.linkage);
  for (const double angle : timing.angles) start.crank_angles.push_back(offset + angle);
  return start;
}

std::optional<PathStart> PathStarts::draw(std::mt19937_64& random, std::size_t count,
                                          const KnownPath* about, Likeness likeness) const {
  const CrankTiming timing = about ? timing_about(random, about->timing) : random_timing(random);
  std::vector<double> half_cos, half_sin;
  for (const double angle : timing.angles) {
    half_cos.push_back(std::cos(0.5 * angle));
    half_sin.push_back(std::sin(0.5 * angle));
  }
  SeparableTarget target;
  target.half_cos = half_cos.data();
  target.half_sin = half_sin.data();
  target.x = x_.data();
  target.y = y_.data();
  target.weight = weight_.data();
  target.count = static_cast<int>(x_.size());
  for (std::size_t j = 0; j < x_.size(); ++j) {
    target.weight_sum += weight_[j];
    target.squares += weight_[j] * (x_[j] * x_[j] + y_[j] * y_[j]);
  }
  target.pivot_fixed = problem_.given.pivot_a.has_value();
  set_limits(target);
  set_direction(target);

  PathCandidates candidates((count + PathCandidates::lanes - 1) / PathCandidates::lanes *
                            PathCandidates::lanes);
  if (about && likeness == Likeness::proportions) {
    fill_about(random, *about, candidates);
  } else {
    fill(random, candidates);
  }
  synthesis::screen(target, candidates);
  double least_error = std::numeric_limits<double>::infinity();
  std::size_t best = 0;
  for (std::size_t i = 0; i < candidates.open.size(); ++i) {
    for (const bool crossed : {false, true}) {
      const double error = crossed ? candidates.crossed[i] : candidates.open[i];
      if (error < least_error) {
        least_error = error;
        best = 2 * i + (crossed ? 1 : 0);
      }
    }
  }
  if (!std::isfinite(least_error)) return std::nullopt;
  return start(target, timing, candidates, best);
}

}  // namespace cognate::problems
