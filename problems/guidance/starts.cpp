#include "problems/guidance/starts.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <set>

#include "analysis/numbers/random.hpp"
#include "problems/guidance/dyads.hpp"
#include "problems/guidance/model.hpp"
#include "synthesis/exact/motion/five_poses.hpp"
#include "synthesis/fit/algebraic_dyads.hpp"
#include "synthesis/search/search.hpp"

namespace cognate::problems {
namespace {

using synthesis::DyadKind;
using synthesis::GuidingDyad;
using synthesis::Pose;
using Five = std::array<std::size_t, 5>;

constexpr int kRefinedDraws = 48;
constexpr int kPlainDraws = 1024;
/// How many starts each source gives at most.
constexpr std::size_t kSubsets = 500, kExactPairs = 24, kNearestLinks = 8, kSlidePairs = 24;
/// Sums of misfits closer than this, relatively, are taken for one pair in another guise.
constexpr double kSameMisfit = 1e-3;

/// All choices of five of `count`, or `kSubsets` of them at random, in order.
std::vector<Five> choices_of_five(std::size_t count, std::mt19937_64& random) {
  std::vector<Five> choices;
  double all = 1;
  for (std::size_t k = 0; k < 5; ++k) all *= double(count - k) / double(k + 1);
  if (all <= double(kSubsets)) {
    std::vector<char> chosen(count, 0);
    std::fill_n(chosen.begin(), 5, 1);
    do {
      Five five{};
      for (std::size_t i = 0, k = 0; i < count; ++i) {
        if (chosen[i]) five.at(k++) = i;
      }
      choices.push_back(five);
    } while (std::prev_permutation(chosen.begin(), chosen.end()));
    return choices;
  }
  std::set<Five> different;
  while (different.size() < kSubsets) {
    std::set<std::size_t> five;
    while (five.size() < 5) five.insert(random() % count);
    Five sorted{};
    std::ranges::copy(five, sorted.begin());
    different.insert(sorted);
  }
  return {different.begin(), different.end()};
}

/// How many poses the mechanism of a pair reaches on the side that fewer are on.
long strays(const MotionProblem& problem, const DyadPair& pair) {
  MotionProblem any = problem;
  any.constraints.no_branch_defect = any.constraints.no_circuit_defect = false;
  const auto sides = form_of(any, pair).sides;
  const long open = std::ranges::count(sides, 1.0);
  return std::min(open, std::ssize(sides) - open);
}

/// The links of one choice of five poses, in pairs.
struct ExactPair {
  GuidingDyad first, second;
  double misfit = 0;
  Five five{};
};

void add_pairs_of(const MotionProblem& problem, const Five& five, std::vector<ExactPair>& pairs) {
  std::array<Pose, 5> poses;
  for (std::size_t k = 0; k < 5; ++k) poses.at(k) = problem.poses[five.at(k)];
  const auto found = synthesis::dyads_of_five_poses(poses);
  std::vector<DyadCandidate> links;
  for (const GuidingDyad& dyad : found.dyads()) {
    if (dyad.kind == DyadKind::rr) links.push_back(conformed(problem, DyadRole::first, dyad));
  }
  for (std::size_t i = 0; i < links.size(); ++i) {
    for (std::size_t j = i + 1; j < links.size(); ++j) {
      const double misfit = links[i].misfit + links[j].misfit;
      if (std::isfinite(misfit)) pairs.push_back({links[i].dyad, links[j].dyad, misfit, five});
    }
  }
}

std::string exact_origin(const Five& five, const std::vector<std::size_t>& numbers) {
  std::string origin = "exact:five-poses";
  for (std::size_t k = 0; k < 5; ++k) {
    origin += fmt::format("{}{}", k == 0 ? ":" : ",", numbers[five.at(k)] + 1);
  }
  return origin;
}

/// Any of the candidates; where `early`, those of little misfit, which come first, more often: half
/// of the choices are of the first quarter.
const DyadCandidate& any_of(const std::vector<DyadCandidate>& sorted, bool early,
                            std::mt19937_64& random) {
  const double share = std::uniform_real_distribution<double>(0, 1)(random);
  const auto index = static_cast<std::size_t>((early ? share * share : share) *
                                              static_cast<double>(sorted.size()));
  return sorted[std::min(index, sorted.size() - 1)];
}

}  // namespace

DyadPair disturbed(const MotionProblem& scaled, const DyadPair& links, std::mt19937_64& random) {
  constexpr double kLeast = 1e-3, kMost = 0.3;
  const double share = std::exp(uniform(random, std::log(kLeast), std::log(kMost)));
  const auto moved = [&](DyadRole role, GuidingDyad link) {
    for (Vec2d* pivot : {&link.in_body, &link.fixed}) {
      const double x = uniform(random, -1, 1), y = uniform(random, -1, 1);
      *pivot = *pivot + (share * link.length) * Vec2d{x, y};
    }
    return conformed(scaled, role, link).dyad;
  };
  const GuidingDyad first = moved(DyadRole::first, links.first);
  return {first, moved(DyadRole::second, links.second)};
}

MotionStarts::MotionStarts(const MotionProblem& scaled, const std::vector<std::size_t>& numbers,
                           std::uint64_t seed, const Deadline& deadline)
    : problem_(scaled),
      alike_(roles_are_alike(scaled)),
      either_drives_(alike_ && !scaled.constraints.required_class &&
                     !scaled.constraints.transmission_angle),
      seed_(seed) {
  slides_ = nearest_slides(problem_);
  if (alike_) {
    add_algebraic();
    add_exact(numbers, deadline);
  }
  add_nearest(deadline);
  first_ = drawn_links(problem_, DyadRole::first, kPlainDraws, seed + 1);
  second_ = drawn_links(problem_, DyadRole::second, kPlainDraws, seed + 2);
  for (auto* links : {&first_, &second_}) {
    std::ranges::stable_sort(*links, {}, &DyadCandidate::misfit);
  }
}

/// A pair whose two links may take either role: both orders, or where nothing distinguishes them
/// the one that stays on one side at more of the poses.
void MotionStarts::add(const GuidingDyad& a, const GuidingDyad& b, const std::string& origin) {
  const DyadPair forth{conformed(problem_, DyadRole::first, a).dyad,
                       conformed(problem_, DyadRole::second, b).dyad};
  const DyadPair back{conformed(problem_, DyadRole::first, b).dyad,
                      conformed(problem_, DyadRole::second, a).dyad};
  if (either_drives_) {
    listed_.push_back({strays(problem_, back) < strays(problem_, forth) ? back : forth, origin});
    return;
  }
  listed_.push_back({forth, origin});
  listed_.push_back({back, origin});
}

void MotionStarts::add_algebraic() {
  const auto dyads = synthesis::algebraic_dyads(problem_.poses);
  for (std::size_t i = 0; i < dyads.size(); ++i) {
    for (std::size_t j = i + 1; j < dyads.size(); ++j) add(dyads[i], dyads[j], "algebraic");
  }
}

void MotionStarts::add_exact(const std::vector<std::size_t>& numbers, const Deadline& deadline) {
  if (problem_.poses.size() < 5) return;
  std::mt19937_64 random(seed_);
  std::vector<ExactPair> pairs;
  for (const Five& five : choices_of_five(problem_.poses.size(), random)) {
    if (deadline.reached()) break;
    add_pairs_of(problem_, five, pairs);
  }
  std::ranges::stable_sort(pairs, {}, &ExactPair::misfit);
  double last = -1;
  std::size_t kept = 0;
  for (const ExactPair& pair : pairs) {
    if (kept == kExactPairs) break;
    if (pair.misfit <= last * (1 + kSameMisfit)) continue;
    last = pair.misfit;
    ++kept;
    add(pair.first, pair.second, exact_origin(pair.five, numbers));
  }
}

void MotionStarts::add_nearest(const Deadline& deadline) {
  const auto links = [&](DyadRole role) {
    const auto draws = drawn_links(problem_, role, kRefinedDraws, seed_);
    auto found = nearest_links(problem_, role, draws, deadline);
    if (found.size() > kNearestLinks) found.resize(kNearestLinks);
    return found;
  };
  const auto first = links(DyadRole::first);
  const auto second = alike_ ? first : links(DyadRole::second);
  for (std::size_t i = 0; i < first.size(); ++i) {
    for (std::size_t j = alike_ ? i + 1 : 0; j < second.size(); ++j) {
      if (alike_) {
        add(first[i].dyad, second[j].dyad, "search");
      } else {
        listed_.push_back({{first[i].dyad, second[j].dyad}, "search"});
      }
    }
  }
  std::size_t pairs = 0;
  for (const DyadCandidate& slide : slides_) {
    for (std::size_t i = 0; i < std::min<std::size_t>(first.size(), 4); ++i) {
      if (pairs++ < kSlidePairs) listed_.push_back({{first[i].dyad, slide.dyad}, "search"});
    }
  }
}

std::optional<MotionStart> MotionStarts::start(int index) const {
  const auto i = static_cast<std::size_t>(index);
  if (i < listed_.size()) return listed_[i];
  if (first_.empty() || second_.empty()) return std::nullopt;
  constexpr unsigned kSlideOneIn = 6;
  std::mt19937_64 random = synthesis::start_random(seed_, index);
  const auto& others = !slides_.empty() && random() % kSlideOneIn == 0 ? slides_ : second_;
  const bool early = index % 2 == 0;
  const GuidingDyad& first = any_of(first_, early, random).dyad;
  return MotionStart{{first, any_of(others, early, random).dyad}, "search"};
}

}  // namespace cognate::problems
