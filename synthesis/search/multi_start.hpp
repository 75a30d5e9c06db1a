/// @file The multi-start search that all kinds of problems share: rounds of starts, their
/// refinement in threads, merging of equal minima, and when to end.
///
/// What a candidate is, and how candidates are ranked and distinguished, a kind says by its rules:
///
///     struct Rules {
///       using Candidate = …;                                // has an int `hits`, 1 for a start
///       bool has_value(const Candidate&) const;             // else it is dropped
///       bool precedes(const Candidate&, const Candidate&) const;  // the order, best first
///       bool is_same(const Candidate& known, const Candidate& other, double tolerance) const;
///       double value(const Candidate&) const;  // objective; infinite where limits are violated
///       double merit(const Candidate&) const;  // optional: what makes a best better; else value
///       void absorb(Candidate& known, const Candidate& same) const;          // optional
///       void keep(std::vector<Candidate>& sorted, std::size_t most) const;   // optional
///       // optional: whether a worse candidate may be on its way to the same minimum
///       bool is_near(const Candidate& best, const Candidate& other) const;
///     };
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "analysis/numbers/parallel.hpp"
#include "synthesis/optimise/solver.hpp"
#include "synthesis/search/deadline.hpp"
#include "synthesis/search/statistics.hpp"

namespace cognate::synthesis {

/// When a search has drawn enough starts.
struct StartRule {
  std::optional<int> starts{};  ///< exactly so many; empty: by the rest
  int round = 100;              ///< starts between two looks at what was found
  int fewest = 200, most = 800;
  int enough_hits = 5;  ///< the best minimum is well known once so many starts led to it
  /// The search also draws so many times the starts after which its best was found; a best that is
  /// better by less than `better_by`, relative to itself, is the same.
  double patience = 0, better_by = 1e-3;
  double met = 0;      ///< values up to this are rounding, none better than another
  double enough = -1;  ///< a best up to this ends the search at once
  /// Nor is the best well known while `SearchStatistics::unseen` is more.
  double doubt = 1;
};

/// A part of the whole search, for progress: 0 … 1.
struct Shares {
  double from = 0, to = 1;

  /// Where so much of it is done.
  double at(double part) const { return from + part * (to - from); }
  /// A part of it, in shares of the whole.
  Shares part(const Shares& of) const { return {at(of.from), at(of.to)}; }
};

/// `options` with the time that is left, and the cancellation.
inline Options until(const Deadline& deadline, Options options) {
  options.time_limit = deadline.remaining();
  options.interrupted = deadline.flag();
  return options;
}

/// What solvers have done.
struct SolverWork {
  std::uint64_t evaluations = 0, gradients = 0, iterations = 0;
};

/// Adds that up, from any thread.
class WorkCounter {
 public:
  /// `times`: what one evaluation of the model counts for.
  void count(const SolverWork& done, std::uint64_t times = 1) const {
    evaluations_ += done.evaluations * times;
    gradients_ += done.gradients * times;
    iterations_ += done.iterations;
  }
  void count(const Solution& solution, std::uint64_t times = 1) const {
    count(
        {solution.evaluations, solution.gradients, static_cast<std::uint64_t>(solution.iterations)},
        times);
  }
  SolverWork total() const { return {evaluations_, gradients_, iterations_}; }

 private:
  mutable std::atomic<std::uint64_t> evaluations_{0}, gradients_{0}, iterations_{0};
};

/// How a search is run: results depend on none of this unless the deadline is reached.
struct SearchRun {
  int threads = 0;  ///< 0: as many as the machine has
  const Deadline& deadline;
  /// Called now and then from one thread with the share done and the best value so far.
  std::function<void(double share, double best)> progress{};
};

/// Drops candidates without a value, sorts the others and counts each that is the same as a better
/// one among the hits of that.
template <class Rules>
void sort_and_merge(const Rules& rules, std::vector<typename Rules::Candidate>& all,
                    double tolerance) {
  using Candidate = typename Rules::Candidate;
  std::erase_if(all, [&](const Candidate& one) { return !rules.has_value(one); });
  std::ranges::stable_sort(
      all, [&](const Candidate& a, const Candidate& b) { return rules.precedes(a, b); });
  std::vector<Candidate> distinct;
  for (Candidate& one : all) {
    const auto known = std::ranges::find_if(
        distinct, [&](const Candidate& other) { return rules.is_same(other, one, tolerance); });
    if (known == distinct.end()) {
      distinct.push_back(std::move(one));
      continue;
    }
    known->hits += one.hits;
    if constexpr (requires { rules.absorb(*known, one); }) rules.absorb(*known, one);
  }
  all = std::move(distinct);
}

/// The state of one search. The same calls give the same candidates for any number of threads.
template <class Rules>
class MultiStart {
 public:
  using Candidate = typename Rules::Candidate;  ///< a start, or what has been made of it

  /// A search without candidates.
  MultiStart(Rules rules, SearchRun run) : rules_(std::move(rules)), run_(std::move(run)) {}

  /// They may change between stages; `merge` then sorts anew.
  Rules& rules() { return rules_; }
  const Rules& rules() const { return rules_; }
  /// Different candidates, best first, after `add` and `merge`.
  std::vector<Candidate>& all() { return all_; }
  const std::vector<Candidate>& all() const { return all_; }
  int starts() const { return starts_; }
  const Deadline& deadline() const { return run_.deadline; }
  bool is_over() const { return run_.deadline.reached(); }

  /// Calls `round(first, count)`, which adds what `count` starts from number `first` on lead to,
  /// until the rule, or `is_enough()`, ends the search.
  template <class Round, class IsEnough>
  void explore(const StartRule& rule, Shares shares, const Round& round, const IsEnough& is_enough);
  /// The same until the best is known.
  template <class Round>
  void explore(const StartRule& rule, Shares shares, const Round& round) {
    explore(rule, shares, round, [&] { return best_is_known(rule); });
  }

  /// Whether the rule's number of starts led to the best, and none to a better one for long.
  bool best_is_known(const StartRule& rule) const {
    return !all_.empty() && all_.front().hits >= rule.enough_hits &&
           starts_ >= rule.patience * best_since_ && statistics(kBestMinima).unseen <= rule.doubt;
  }

  /// Calls `body(index)` for each index in [0, count), in threads, unless the deadline is reached.
  /// `part`: of the present stage, for progress.
  template <class Body>
  void for_each(std::size_t count, const Body& body, Shares part = {}) const;

  /// Begins a stage of the search and calls `refine(candidate)` for each candidate.
  template <class Refine>
  void refine(Shares shares, const Refine& refine) {
    stage_ = shares;
    for_each(all_.size(), [&](std::size_t i) {
      refine(all_[i]);
      note_value(all_[i]);
    });
    report(1);
  }

  /// Leaves the best `most`.
  void keep(std::size_t most) {
    if (all_.size() <= most) return;
    if constexpr (requires { rules_.keep(all_, most); }) {
      rules_.keep(all_, most);
    } else {
      all_.erase(all_.begin() + static_cast<std::ptrdiff_t>(most), all_.end());
    }
  }

  /// Sorts the candidates and merges those that are the same.
  void merge(double tolerance) { sort_and_merge(rules_, all_, tolerance); }

  /// Adds candidates and merges.
  void add(std::vector<Candidate> fresh, double tolerance) {
    for (const Candidate& one : fresh) note_value(one);
    std::ranges::move(fresh, std::back_inserter(all_));
    merge(tolerance);
  }

  /// Lowers the best value that progress shows; from any thread.
  void note_value(const Candidate& one) const {
    if (!rules_.has_value(one)) return;
    const double value = rules_.value(one);
    double known = best_;
    while (value < known && !best_.compare_exchange_weak(known, value)) {
    }
  }

  /// Reports how much of the present stage is done, by one thread at a time; what a round does more
  /// than once does not take back what has been reported.
  void report(double part) const {
    if (!run_.progress) return;
    reported_ = std::max(reported_, stage_.at(part));
    run_.progress(reported_, best_);
  }

  /// Of the candidates that there are, of which those within limits count, and the starts that led
  /// to them. Candidates near one another count as one. `most`: of the best so many.
  SearchStatistics statistics(std::size_t most = std::numeric_limits<std::size_t>::max()) const {
    std::ptrdiff_t seen_once = 0, reached = 0, hits = 0;
    const Candidate* best = nullptr;  // of those near one another
    const auto close = [&] {
      seen_once += best && hits <= 1;
      reached += std::exchange(hits, 0);
    };
    for (const Candidate& one : all_) {
      if (!is_feasible(one)) continue;
      if (!best || !is_near(*best, one)) {
        if (best && --most == 0) break;
        close();
        best = &one;
      }
      hits += one.hits;
    }
    close();
    return {starts_, all_.empty() ? 0 : all_.front().hits, unseen_probability(seen_once, reached)};
  }

 private:
  void note_best(const StartRule& rule) {
    if (all_.empty()) return;
    const double value = std::max(merit(all_.front()), rule.met);
    if (!(value < (1 - rule.better_by) * best_value_)) return;
    best_value_ = value;
    best_since_ = starts_;
  }

  bool is_feasible(const Candidate& one) const {
    return merit(one) < std::numeric_limits<double>::infinity();
  }

  bool is_near([[maybe_unused]] const Candidate& best,
               [[maybe_unused]] const Candidate& other) const {
    if constexpr (requires { rules_.is_near(best, other); }) {
      return rules_.is_near(best, other);
    } else {
      return false;
    }
  }

  double merit(const Candidate& one) const {
    if constexpr (requires { rules_.merit(one); }) {
      return rules_.merit(one);
    } else {
      return rules_.value(one);
    }
  }

  Rules rules_;
  SearchRun run_;
  std::vector<Candidate> all_;
  int starts_ = 0;
  int best_since_ = 0;  ///< after how many starts the best was found
  double best_value_ = std::numeric_limits<double>::infinity();
  Shares stage_{0, 0};
  mutable double reported_ = 0;
  mutable std::atomic<double> best_{std::numeric_limits<double>::infinity()};  ///< for progress
};

/// The share of an exploration that is done after so many starts: most end with the fewest.
inline double explored_share(const StartRule& rule, int starts) {
  constexpr double kByFewest = 0.85;
  if (rule.starts) return double(starts) / std::max(1, *rule.starts);
  if (starts <= rule.fewest) return kByFewest * starts / std::max(1, rule.fewest);
  return kByFewest + (1 - kByFewest) * (starts - rule.fewest) / (rule.most - rule.fewest);
}

template <class Rules>
template <class Round, class IsEnough>
void MultiStart<Rules>::explore(const StartRule& rule, Shares shares, const Round& round,
                                const IsEnough& is_enough) {
  const int most = rule.starts.value_or(rule.most);
  while (starts_ < most && !is_over()) {
    const int first = starts_, count = std::min(rule.round, most - first);
    stage_ = shares.part({explored_share(rule, first), explored_share(rule, first + count)});
    round(first, count);
    starts_ += count;
    report(1);
    note_best(rule);
    if (!rule.starts && !all_.empty() && merit(all_.front()) <= rule.enough) break;
    if (!rule.starts && starts_ >= rule.fewest && is_enough()) break;
  }
}

template <class Rules>
template <class Body>
void MultiStart<Rules>::for_each(std::size_t count, const Body& body, Shares part) const {
  parallel_for(static_cast<int>(count), run_.threads, [&](int index, int thread) {
    if (is_over()) return;
    body(static_cast<std::size_t>(index));
    if (thread == 0) report(part.at(double(index + 1) / double(count)));
  });
}

}  // namespace cognate::synthesis
