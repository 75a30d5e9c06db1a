#include "synthesis/exact/nine_point/follow.hpp"

#include <algorithm>
#include <cmath>

namespace cognate::synthesis::nine_point {
namespace {

/// A path that gets so near its end but no nearer, at finite pivots, ends at a singular root.
constexpr double kNearEnd = 1e-8;
/// With pivots of this size it is going to infinity.
constexpr double kFar = 1e3;
/// Foci beyond are at infinity.
constexpr double kDiverged = 1e12;
/// For double-double numbers, see TrackSettings.
constexpr double kExtendedNoise = 1e-22, kExtendedStep = 1e-20;
/// Of predictions along paths that one of them has left for the other.
constexpr double kCarefulPrediction = 1e-5;

/// How far the path of a start has been followed.
struct Outcome {
  PathEnd how = PathEnd::unfinished;
  double remaining = 1;
  RootNumbers numbers;  ///< there
  Fingerprint print;    ///< of a root that was reached
};

double greatest_pivot(std::span<const Pair> root) {
  double greatest = 0;
  for (const Pair& z : root.first(kPivots)) greatest = std::max(greatest, std::abs(number(z)));
  return greatest;
}

bool is_finite(const Fingerprint& print) {
  return std::isfinite(print.size) && print.size < kDiverged;
}

class Follower {
 public:
  Follower(const StartSet& set, const PathParameters& data, const TrackingOptions& means)
      : set_(set),
        means_(means),
        kind_(data.kind),
        line_(parameter_line(set.data, data)),
        outcomes_(set.count()) {}

  FollowedPaths run() {
    std::vector<int> all(outcomes_.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      all[i] = static_cast<int>(i);
      restart(all[i]);
    }
    go_on(all, means_);
    for (int chart = 1; chart < charts(); ++chart) repeat(means_);
    TrackingOptions extended = means_;
    extended.extended = true;
    extended.settings.noise = kExtendedNoise;
    extended.settings.least_step = kExtendedStep;
    for (int chart = 0; chart < charts(); ++chart) repeat(extended);
    return collect();
  }

 private:
  /// Solutions of class (1, 8) have three charts: themselves and their cognates.
  int charts() const { return kind_.poses == 1 ? 3 : 1; }

  void restart(int path) {
    const auto root = set_.root(path);
    outcomes_[path] = {PathEnd::unfinished, 1, RootNumbers(root.begin(), root.end()), {}};
  }

  /// Goes on along some paths from where they are.
  void go_on(const std::vector<int>& which, const TrackingOptions& means) {
    PathBundle bundle{kind_.points, {}, {}, std::vector<int>(which.size(), 0), {line_}};
    for (const int path : which) {
      const Outcome& outcome = outcomes_[path];
      bundle.starts.insert(bundle.starts.end(), outcome.numbers.begin(), outcome.numbers.end());
      bundle.from.push_back(outcome.remaining);
    }
    const TrackedPaths paths = track(bundle, means);
    for (std::size_t i = 0; i < which.size(); ++i) {
      if (paths.how[i] == PathEnd::unfinished) {
        stopped_ = true;
        continue;
      }
      Outcome& outcome = outcomes_[which[i]];
      const auto end = paths.end(static_cast<int>(i), kind_.points);
      outcome = {paths.how[i], paths.remaining[i], RootNumbers(end.begin(), end.end()), {}};
      classify(outcome);
    }
  }

  void classify(Outcome& outcome) const {
    if (outcome.how != PathEnd::reached) return;
    outcome.print = fingerprint(kind_, outcome.numbers);
    if (!is_finite(outcome.print)) outcome.how = PathEnd::infinite;
  }

  /// Paths without an end, and those that share theirs with another.
  std::vector<int> doubtful() const {
    std::vector<int> found, first;  // the path that had each fingerprint first
    FingerprintIndex index;
    for (std::size_t i = 0; i < outcomes_.size(); ++i) {
      const Outcome& outcome = outcomes_[i];
      const int path = static_cast<int>(i);
      if (outcome.how == PathEnd::infinite) continue;
      if (outcome.how != PathEnd::reached) {
        found.push_back(path);
        continue;
      }
      const int other = index.find(outcome.print, kSameRoot);
      if (other < 0) {
        index.add(outcome.print);
        first.push_back(path);
      } else {
        found.push_back(path);
        found.push_back(first[other]);
      }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

  /// Follows doubtful paths again with other means: one that is stuck from there in another chart,
  /// one of several with the same end from its start, more carefully.
  void repeat(const TrackingOptions& means) {
    if (stopped_) return;
    const std::vector<int> which = doubtful();
    repeated_ = std::max(repeated_, static_cast<int>(which.size()));
    std::vector<int> stuck, same;
    for (const int path : which) {
      (outcomes_[path].how == PathEnd::reached ? same : stuck).push_back(path);
    }
    const std::vector<Outcome> before = outcomes_;
    for (const int path : stuck) change_chart(outcomes_[path]);
    if (!stuck.empty()) go_on(stuck, means);
    for (const int path : same) restart(path);
    TrackingOptions careful = means;
    careful.settings.prediction = kCarefulPrediction;
    if (!same.empty()) go_on(same, careful);
    for (const int path : same) {
      if (outcomes_[path].how != PathEnd::reached) outcomes_[path] = before[path];
    }
  }

  void change_chart(Outcome& outcome) const {
    if (charts() == 1) return;
    const PathParameters here = parameters_at(line_, outcome.remaining, kind_);
    outcome.numbers = next_cognate(here, outcome.numbers);
  }

  FollowedPaths collect() const {
    FollowedPaths all;
    all.repeated = repeated_;
    all.stopped = stopped_;
    FingerprintIndex index;
    for (const Outcome& outcome : outcomes_) {
      const bool near_end = outcome.how == PathEnd::stuck && outcome.remaining < kNearEnd;
      if (outcome.how == PathEnd::infinite) {
        ++all.at_infinity;
      } else if (near_end) {
        ++(greatest_pivot(outcome.numbers) > kFar ? all.at_infinity : all.singular);
      } else if (outcome.how != PathEnd::reached) {
        ++all.lost;
      } else if (index.find(outcome.print, kSameRoot) >= 0) {
        ++all.duplicates;
      } else {
        index.add(outcome.print);
        all.roots.insert(all.roots.end(), outcome.numbers.begin(), outcome.numbers.end());
      }
    }
    return all;
  }

  const StartSet& set_;
  const TrackingOptions& means_;
  PathClass kind_;
  ParameterLine line_;
  std::vector<Outcome> outcomes_;
  int repeated_ = 0;
  bool stopped_ = false;
};

}  // namespace

FollowedPaths follow(const StartSet& set, const PathParameters& data,
                     const TrackingOptions& means) {
  return Follower(set, data, means).run();
}

}  // namespace cognate::synthesis::nine_point
