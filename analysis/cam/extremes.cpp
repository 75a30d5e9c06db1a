#include "analysis/cam/extremes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/cam/subdivision.hpp"

namespace cognate::cam {
namespace {

/// Relative to the size of the function: waves smaller than this are rounding, and where the
/// function varies by less than `kFlat`, its derivative is not searched any further.
constexpr double kWave = 1e-13, kFlat = 1e-14;

/// A place that may be an extreme.
struct Candidate {
  Extreme extreme;
  double rounding = 0;    ///< of the value
  bool is_exact = false;  ///< an end or a zero of the derivative; else only a sample

  double value() const { return extreme.value; }
};

/// Whether `a` is more (`sense` 1) or less (-1) than `b`. Between two that are equal but for
/// rounding, the one whose place is known counts as more.
bool beats(const Candidate& a, const Candidate& b, double sense) {
  const double change = sense * (a.value() - b.value());
  if (a.is_exact == b.is_exact) return change > 0;
  const double rounding = std::max(a.rounding, b.rounding);
  return change > (b.is_exact ? rounding : -rounding);
}

double rounding_of(const Subinterval& on) {
  const bool is_noisy = std::isfinite(on.misfit) && on.misfit > Subdivision::kTight * on.size;
  return std::max(kWave * on.size, is_noisy ? 2 * on.misfit : 0);
}

Candidate interval_end(const Extreme& extreme, double scale) {
  return {extreme, kWave * std::max(std::abs(extreme.value), scale), true};
}

Candidate sample(const Subinterval& on, std::size_t j) {
  return {{on.at(chebyshev_node(j)), on.values[j]}, rounding_of(on), false};
}

Candidate stationary(FunctionRef f, const Subinterval& on, double t) {
  return {{on.at(t), f(on.at(t))}, rounding_of(on), true};
}

/// Finds the sign changes of the derivative of a resolved function.
template <class Skip, class Found>
void stationary_places(const Subinterval& on, Skip&& skip, Found&& found) {
  const SignChanges changes(on.series, SignChanges::Of::derivative, kFlat * on.size);
  changes.visit(changes.is_positive_at(-1), changes.is_positive_at(1), skip, found);
}

/// Drops all of the candidates, in order from end to end, but the places between the ends where the
/// course turns by more than rounding.
class Turns {
 public:
  explicit Turns(std::vector<Extreme>& kept) : kept_(kept) {}

  void take(const Candidate& candidate) {
    if (!std::isfinite(candidate.value())) return;
    const double change = candidate.value() - last_.value();
    const bool is_within = std::abs(change) <= std::max(last_.rounding, candidate.rounding);
    if (is_first_) {
      is_first_ = false;
      last_ = candidate;
    } else if (sense_ == 0) {
      if (is_within) return;
      sense_ = change > 0 ? 1 : -1;
      last_ = candidate;
    } else if (beats(candidate, last_, sense_)) {
      last_ = candidate;
    } else if (!is_within) {
      kept_.push_back(last_.extreme);
      sense_ = -sense_;
      last_ = candidate;
    }
  }

 private:
  std::vector<Extreme>& kept_;
  Candidate last_;    ///< the highest on the way up, the lowest on the way down
  double sense_ = 0;  ///< up 1, down -1, not known yet 0
  bool is_first_ = true;
};

/// The best found so far, in one sense.
class Champion {
 public:
  Champion(double sense, const Candidate& start) : sense_(sense), best_(start) {}

  void offer(const Candidate& candidate) {
    if (!std::isfinite(candidate.value())) return;
    if (!std::isfinite(best_.value()) || beats(candidate, best_, sense_)) best_ = candidate;
  }

  /// Whether a value may be better than the best, or the same with a place better known.
  bool may_yield_to(double value) const {
    return !(sense_ * (value - best_.value()) < -best_.rounding);
  }

  /// Whether one of the values of a series may.
  bool may_yield_to(const ChebyshevSeries& piece) const {
    return may_yield_to(piece[0] + sense_ * variation_bound(piece));
  }

  const Extreme& extreme() const { return best_.extreme; }

 private:
  double sense_;
  Candidate best_;
};

/// Zeros where only samples are known: each change of sign between two.
void sampled_zeros(const Subinterval& on, std::vector<double>& at) {
  for (std::size_t j = 1; j < kChebyshevSize; ++j) {
    const double before = on.values[j - 1], after = on.values[j];
    if (!std::isfinite(before) || !std::isfinite(after)) continue;
    if (is_positive(before) == is_positive(after)) continue;
    const std::size_t nearer = std::abs(before) < std::abs(after) ? j - 1 : j;
    at.push_back(on.at(chebyshev_node(nearer)));
  }
}

}  // namespace

void local_extremes(FunctionRef f, double from, double to, double scale,
                    std::vector<Extreme>& extremes) {
  Subdivision parts(f, from, to, scale);
  std::vector<Candidate> candidates;
  while (const Subinterval* on = parts.next()) {
    if (on->to < to) candidates.push_back(sample(*on, kChebyshevDegree));
    if (parts.is_resolved()) {
      const auto never = [](const ChebyshevSeries&) { return false; };
      stationary_places(*on, never, [&](double t) { candidates.push_back(stationary(f, *on, t)); });
    } else {
      for (std::size_t j = 1; j < kChebyshevDegree; ++j) candidates.push_back(sample(*on, j));
    }
  }
  std::ranges::stable_sort(candidates, {}, [](const Candidate& c) { return c.extreme.at; });

  extremes.assign(1, parts.begin());
  Turns turns(extremes);
  turns.take(interval_end(parts.begin(), parts.scale()));
  for (const Candidate& candidate : candidates) turns.take(candidate);
  turns.take(interval_end(parts.end(), parts.scale()));
  if (from < to) extremes.push_back(parts.end());
}

Extremes extremes(FunctionRef f, double from, double to, double scale) {
  Subdivision parts(f, from, to, scale);
  const Candidate begin = interval_end(parts.begin(), parts.scale());
  Champion least(-1, begin), greatest(1, begin);
  const auto offer = [&](const Candidate& candidate) {
    least.offer(candidate);
    greatest.offer(candidate);
  };
  const auto is_beaten = [&](const auto& value_or_piece) {
    return !least.may_yield_to(value_or_piece) && !greatest.may_yield_to(value_or_piece);
  };
  offer(interval_end(parts.end(), parts.scale()));
  while (const Subinterval* on = parts.next()) {
    for (std::size_t j = 0; j < kChebyshevSize; ++j) offer(sample(*on, j));
    if (!parts.is_resolved()) continue;
    stationary_places(*on, is_beaten, [&](double t) {
      if (!is_beaten(value_and_slope(on->series, t).value)) offer(stationary(f, *on, t));
    });
  }
  return {least.extreme(), greatest.extreme()};
}

void zeros(FunctionRef f, double from, double to, double scale, std::vector<double>& at) {
  at.clear();
  Subdivision parts(f, from, to, scale);
  const auto never = [](const ChebyshevSeries&) { return false; };
  while (const Subinterval* on = parts.next()) {
    if (!parts.is_resolved()) {
      sampled_zeros(*on, at);
      continue;
    }
    // The signs of f itself, for both neighbours of a joint the same.
    const SignChanges changes(on->series, SignChanges::Of::series, kFlat * on->size);
    changes.visit(is_positive(on->values.front()), is_positive(on->values.back()), never,
                  [&](double t) { at.push_back(on->at(t)); });
  }
  std::ranges::sort(at);
  const double rounding =
      4 * std::numeric_limits<double>::epsilon() * std::max(std::abs(from), std::abs(to));
  std::erase_if(at, [&](double x) { return x - from <= rounding || to - x <= rounding; });
}

}  // namespace cognate::cam
