/// When the crank of a start passes the points.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/random.hpp"
#include "problems/path/crank_sense.hpp"
#include "problems/path/starts.hpp"

namespace cognate::problems {
namespace {

/// Of a closed curve: the greatest amplitude of the logarithm of its speed.
constexpr double kMostVariation = 2;
/// Of the logarithms of steps that are known, and what is added to each, of an even step.
constexpr double kMostDisturbance = 0.5, kLeastStep = 0.02;

}  // namespace

double PathStarts::gap(std::size_t from, std::size_t to) const {
  const Vec2d step = problem_.points[to] - problem_.points[from];
  return std::hypot(step.x, step.y);
}

/// The order in which the points are met: as given; where any order will do, half the time as given
/// all the same, else from a random point on to the nearest one left or, one time in four, to any.
std::vector<std::size_t> PathStarts::random_tour(std::mt19937_64& random) const {
  std::vector<std::size_t> tour(problem_.points.size());
  std::iota(tour.begin(), tour.end(), std::size_t{0});
  if (problem_.order == PointOrder::cyclic || random() % 2 == 0) return tour;
  std::swap(tour[0], tour[random() % tour.size()]);
  for (std::size_t k = 1; k + 1 < tour.size(); ++k) {
    const auto rest = tour.begin() + static_cast<std::ptrdiff_t>(k);
    const auto nearest = std::min_element(rest, tour.end(), [&](std::size_t a, std::size_t b) {
      return gap(tour[k - 1], a) < gap(tour[k - 1], b);
    });
    const bool stray = random() % 4 == 0;
    std::swap(tour[k], stray ? tour[k + random() % (tour.size() - k)] : *nearest);
  }
  return tour;
}

/// For each step of the tour, the one back to its first point the last, a mixture of its length and
/// equal steps, disturbed at random.
std::vector<double> PathStarts::random_shares(std::mt19937_64& random,
                                              const std::vector<std::size_t>& tour) const {
  const std::size_t n = tour.size();
  std::vector<double> gaps(n);
  for (std::size_t k = 0; k < n; ++k) gaps[k] = gap(tour[k], tour[(k + 1) % n]);
  const double mean_gap = std::accumulate(gaps.begin(), gaps.end(), 0.0) / double(n);
  const double by_length = uniform(random, 0, 1);
  std::normal_distribution<double> disturbance(0, uniform(random, 0.01, 0.8));
  std::vector<double> share(n);
  for (std::size_t k = 0; k < n; ++k) {
    share[k] = (by_length * gaps[k] + (1 - by_length) * mean_gap) * std::exp(disturbance(random));
  }
  if (gaps.back() == 0) share.back() = 0;
  return share;
}

/// Increments from point to point in proportion to random shares, over the whole turn or a part.
std::vector<double> PathStarts::random_increments(std::mt19937_64& random) const {
  const std::vector<std::size_t> tour = random_tour(random);
  const std::size_t n = tour.size();
  std::vector<double> share = random_shares(random, tour);
  // Over the whole turn the step from the last point back to the first takes its share.
  const bool whole_turn = random() % 2 == 0;
  if (!whole_turn) share.back() = 0;
  const double sweep = whole_turn ? kTurn : uniform(random, 0.1, 1) * kTurn;
  const double total = std::accumulate(share.begin(), share.end(), 0.0);
  std::vector<double> angles(n);
  double angle = 0;
  for (std::size_t k = 0; k < n; ++k) {
    angles[tour[k]] = angle;
    angle += sweep * share[k] / total;
  }
  return angles;
}

/// Angles at all points, of which some are timed: the others share the steps between those, and
/// what is left of the turn, at random.
std::vector<double> PathStarts::random_between(std::mt19937_64& random) const {
  const std::size_t n = problem_.points.size();
  std::vector<std::size_t> tour(n), timed;
  std::iota(tour.begin(), tour.end(), std::size_t{0});
  for (std::size_t j = 0; j < n; ++j) {
    if (problem_.is_timed(j)) timed.push_back(j);
  }
  std::vector<double> share = random_shares(random, tour);
  const bool whole_turn = random() % 2 == 0;
  if (!whole_turn) share.back() *= std::exp(uniform(random, 0, 4));
  auto senses = senses_between(problem_);
  if (leaves_sense_open(problem_) && problem_.crank_sense != CrankSense::either) {
    senses = {problem_.crank_sense == CrankSense::ccw, problem_.crank_sense == CrankSense::cw};
  }
  const bool forward = senses.forward && (!senses.backward || random() % 2 == 0);
  const double sense = forward ? 1 : -1;

  std::vector<double> angles = problem_.crank_angles;
  for (std::size_t k = 0; k < timed.size(); ++k) {
    const bool last = k + 1 == timed.size();
    const std::size_t from = timed[k], to = last ? timed[0] + n : timed[k + 1];
    const double end = problem_.crank_angles[to % n];
    const double step = in_one_turn(sense * (end - angles[from]));
    constexpr double kNoStep = 1e-9;  // a last point that repeats the first, to rounding
    const double sweep = step > kNoStep ? step : kTurn;
    double total = 0, part = 0;
    for (std::size_t i = from; i < to; ++i) total += share[i % n];
    for (std::size_t i = from; i + 1 < to; ++i) {
      part += share[i % n];
      angles[(i + 1) % n] = angles[from] + sense * sweep * part / total;
    }
  }
  return angles;
}

/// The steps from point to point of a known timing, in the order in which it meets them, each
/// disturbed at random; the sum is a whole turn.
PathStarts::CrankTiming PathStarts::timing_about(std::mt19937_64& random,
                                                 const CrankTiming& known) const {
  const std::size_t n = known.angles.size();
  std::vector<double> at(n), share(n);
  for (std::size_t j = 0; j < n; ++j) {
    at[j] = in_one_turn((known.clockwise ? -1 : 1) * (known.angles[j] - known.angles[0]));
  }
  std::vector<std::size_t> tour(n);
  std::iota(tour.begin(), tour.end(), std::size_t{0});
  if (problem_.order == PointOrder::any) {
    std::ranges::stable_sort(tour, {}, [&](std::size_t j) { return at[j]; });
  }
  std::normal_distribution<double> disturbance(0, uniform(random, 0.01, kMostDisturbance));
  double total = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const double step = in_one_turn(at[tour[(k + 1) % n]] - at[tour[k]]);
    // Points that share their place may part.
    share[k] = (step + kLeastStep * kTurn / double(n)) * std::exp(disturbance(random));
    total += share[k];
  }
  CrankTiming timing{std::vector<double>(n), known.clockwise};
  double angle = 0;
  for (std::size_t k = 0; k < n; ++k) {
    timing.angles[tour[k]] = (known.clockwise ? -1 : 1) * angle * kTurn / total;
    angle += share[k];
  }
  return timing;
}

std::vector<double> PathStarts::random_angles(std::mt19937_64& random) const {
  switch (problem_.timing) {
    case Timing::free:
      return problem_.constraints.full_turn ? closed_increments(random) : random_increments(random);
    case Timing::mixed:
      return random_between(random);
    case Timing::prescribed:
      break;
  }
  return problem_.crank_angles;
}

/// Over a closed curve the crank turns once, and the path's speed changes smoothly, several times
/// at most: its logarithm is a short Fourier series of random phases, in the share of the way.
std::vector<double> PathStarts::closed_increments(std::mt19937_64& random) const {
  constexpr int kHarmonics = 3;
  double amplitude[kHarmonics], phase[kHarmonics];
  const double variation = uniform(random, 0, kMostVariation);
  for (int k = 0; k < kHarmonics; ++k) {
    amplitude[k] = uniform(random, 0, variation) / (k + 1);
    phase[k] = uniform(random, 0, kTurn);
  }
  const std::size_t n = problem_.points.size();
  std::vector<double> angles(n);
  double way = 0, at = 0, angle = 0;
  for (std::size_t j = 0; j < n; ++j) way += gap(j, (j + 1) % n);
  for (std::size_t j = 0; j < n; ++j) {
    angles[j] = angle;
    const double step = gap(j, (j + 1) % n);
    const double share = (at + 0.5 * step) / way;
    double slowness = 0;
    for (int k = 0; k < kHarmonics; ++k) {
      slowness += amplitude[k] * std::cos((k + 1) * kTurn * share + phase[k]);
    }
    angle += step * std::exp(slowness);
    at += step;
  }
  for (double& each : angles) each *= kTurn / angle;
  return angles;
}

PathStarts::CrankTiming PathStarts::random_timing(std::mt19937_64& random) const {
  const bool increments =
      problem_.timing == Timing::free || problem_.crank_reference == CrankReference::first;
  CrankTiming timing;
  timing.clockwise = increments && (problem_.crank_sense == CrankSense::cw ||
                                    (problem_.crank_sense == CrankSense::either && random() % 2));
  timing.angles = random_angles(random);
  if (!increments) return timing;
  const double first = timing.angles[first_timed_];
  for (double& angle : timing.angles) angle = (timing.clockwise ? -1 : 1) * (angle - first);
  return timing;
}

}  // namespace cognate::problems
