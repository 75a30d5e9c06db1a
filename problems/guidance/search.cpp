#include "problems/guidance/search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace cognate::problems {
namespace {

using synthesis::DyadKind;
using synthesis::GuidingDyad;

constexpr double kApart = 0.2;        // extents between starts of refinements
constexpr double kSameResult = 0.05;  // and between results
constexpr int kRounds = 14;           // halvings of the step
constexpr int kMostSteps = 40;        // in one round
constexpr std::size_t kSpare = 4;     // refinements for each design wanted

/// Two choices, of which either may drive.
struct Candidate {
  const DyadChoice* first = nullptr;
  const DyadChoice* second = nullptr;
  Judgement judgement;
  bool second_drives = false;
};

DyadPair ordered(const GuidingDyad& first, const GuidingDyad& second, bool second_drives) {
  return second_drives ? DyadPair{second, first} : DyadPair{first, second};
}

/// Greatest distance of the pivots, as far as the kinds have them.
double distance(const GuidingDyad& a, const GuidingDyad& b) {
  if (a.kind != b.kind) return std::numeric_limits<double>::infinity();
  const double moving = a.kind == DyadKind::rp ? 0 : norm(a.in_body - b.in_body);
  const double fixed = a.kind == DyadKind::pr ? 0 : norm(a.fixed - b.fixed);
  return std::max(moving, fixed);
}

double distance(const DyadPair& a, const DyadPair& b) {
  const double straight = std::max(distance(a.first, b.first), distance(a.second, b.second));
  const double across = std::max(distance(a.first, b.second), distance(a.second, b.first));
  return std::min(straight, across);
}

class Search {
 public:
  Search(const MotionProblem& problem, const DyadPairChoices& options, const Deadline& deadline)
      : problem_(problem),
        first_(options.first),
        second_(options.second ? *options.second : options.first),
        one_dyad_(!options.second),
        deadline_(deadline),
        extent_(synthesis::extent(problem.poses)) {}

  RankedPairs all(int count) {
    judge_all();
    const bool is_family = first_.is_family() || second_.is_family();
    RankedPairs ranked;
    if (is_family) {
      ranked.pairs = improved(count);
    } else {
      for (const Candidate& candidate : candidates_) ranked.pairs.push_back(as_pair(candidate));
    }
    ranked.judged = judged_;
    return ranked;
  }

 private:
  static bool better(const Candidate& a, const Candidate& b) {
    return a.judgement.is_better_than(b.judgement);
  }

  static RankedPair as_pair(const Candidate& candidate) {
    return {ordered(candidate.first->dyad, candidate.second->dyad, candidate.second_drives),
            candidate.judgement};
  }

  std::optional<Judgement> judged(const DyadPair& pair) {
    ++judged_;
    return judge(problem_, pair);
  }

  /// Whether a step pays: what rounding gains does not, nor less than anyone would see.
  static bool is_gain(const Judgement& found, const Judgement& best) {
    constexpr double kLeast = 1e-4;
    return found.violation != best.violation ? found.violation < best.violation
                                             : found.merit > best.merit + kLeast;
  }

  /// The better order of driving. A user's order of pivots is kept unless it breaks a constraint
  /// that the other does not.
  std::optional<Candidate> candidate(const DyadChoice& first, const DyadChoice& second) {
    const auto forth = judged({first.dyad, second.dyad});
    if (!forth) return std::nullopt;
    Candidate made{&first, &second, *forth, false};
    if (!one_dyad_ && forth->violation == 0) return made;
    const auto back = judged({second.dyad, first.dyad});
    if (back && back->is_better_than(*forth) && (one_dyad_ || back->violation < forth->violation)) {
      made.judgement = *back;
      made.second_drives = true;
    }
    return made;
  }

  void judge_all() {
    for (std::size_t i = 0; i < first_.choices.size(); ++i) {
      if (deadline_.reached()) break;
      for (std::size_t j = one_dyad_ ? i + 1 : 0; j < second_.choices.size(); ++j) {
        if (const auto made = candidate(first_.choices[i], second_.choices[j])) {
          candidates_.push_back(*made);
        }
      }
    }
    std::ranges::stable_sort(candidates_, better);
  }

  std::vector<RankedPair> improved(int count) {
    const std::size_t starts = kSpare * static_cast<std::size_t>(count);
    std::vector<RankedPair> begun, found;
    for (const Candidate& candidate : candidates_) {
      if (begun.size() >= starts || deadline_.reached()) break;
      const RankedPair start = as_pair(candidate);
      if (has_like(begun, start, kApart)) continue;
      begun.push_back(start);
      found.push_back(refined(candidate));
    }
    std::ranges::stable_sort(found, [](const RankedPair& a, const RankedPair& b) {
      return a.judgement.is_better_than(b.judgement);
    });
    std::vector<RankedPair> kept;
    for (const RankedPair& pair : found) {
      if (!has_like(kept, pair, kSameResult)) kept.push_back(pair);
    }
    return kept;
  }

  bool has_like(const std::vector<RankedPair>& pairs, const RankedPair& pair, double part) const {
    const double size = extent_ > 0 ? extent_ : longest_link(pair.pair);
    return std::ranges::any_of(pairs, [&](const RankedPair& other) {
      return distance(other.pair, pair.pair) <= part * size;
    });
  }

  /// Steps along one parameter at a time, as long as they help; then half as far.
  RankedPair refined(const Candidate& start) {
    DyadChoice a = *start.first, b = *start.second;
    Judgement best = start.judgement;
    for (int round = 0; round < kRounds; ++round) {
      bool moved = true;
      for (int step = 0; moved && step < kMostSteps && !deadline_.reached(); ++step) {
        moved = stepped(first_, a, b, true, start.second_drives, best);
        moved = stepped(second_, b, a, false, start.second_drives, best) || moved;
      }
      for (DyadChoice* choice : {&a, &b}) {
        for (double& step : choice->step) step /= 2;
      }
    }
    return {ordered(a.dyad, b.dyad, start.second_drives), best};
  }

  bool stepped(const DyadChoices& options, DyadChoice& moving, const DyadChoice& other,
               bool is_first, bool second_drives, Judgement& best) {
    if (!options.is_family()) return false;
    bool moved = false;
    for (std::size_t k = 0; k < moving.at.size(); ++k) {
      for (const double sense : {1.0, -1.0}) {
        if (moving.step.at(k) == 0) continue;
        DyadChoice tried = moving;
        tried.at.at(k) += sense * moving.step.at(k);
        const auto dyad = options.dyad_at(tried.at);
        if (!dyad) continue;
        tried.dyad = *dyad;
        const auto found = judged(is_first ? ordered(tried.dyad, other.dyad, second_drives)
                                           : ordered(other.dyad, tried.dyad, second_drives));
        if (!found || !is_gain(*found, best)) continue;
        best = *found;
        moving = tried;
        moved = true;
        break;
      }
    }
    return moved;
  }

  const MotionProblem& problem_;
  const DyadChoices& first_;
  const DyadChoices& second_;
  bool one_dyad_;
  const Deadline& deadline_;
  double extent_;
  std::vector<Candidate> candidates_;
  std::uint64_t judged_ = 0;
};

}  // namespace

RankedPairs ranked_pairs(const MotionProblem& problem, const DyadPairChoices& options, int count,
                         const Deadline& deadline) {
  return Search(problem, options, deadline).all(count);
}

}  // namespace cognate::problems
