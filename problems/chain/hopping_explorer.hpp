/// @file The search of one topology whose valleys are curved and narrow: fits from drawn starts,
/// then mostly from disturbed good designs.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "analysis/numbers/random.hpp"
#include "problems/chain/space.hpp"
#include "problems/chain/topology_searches.hpp"

namespace cognate::problems {

/// Changes each free dimension of a chain by up to the share `size` of it.
inline void disturb(const ChainSpace& space, double size, synthesis::ChainDesign& chain,
                    std::mt19937_64& random) {
  constexpr double kLeast = 0.3;
  for (const int parameter : space.free) {
    double& value = chain.parameters[static_cast<std::size_t>(parameter)];
    value += size * uniform(random, -1, 1) * std::max(kLeast, std::abs(value));
  }
}

/// How many starts, and what of the designs found is kept.
inline constexpr int kHoppingRound = 64;  ///< starts between two looks at what was found
/// Relative: closer designs are one.
inline constexpr double kSameHoppingDesign = 0.02;

/// `Method` says of one kind of problem
/// - `Space`, `Design` and `Rules` (those of a MultiStart), whose candidates have a `design`;
/// - `draw(space, random)`, a start, or none where the draw came to nothing;
/// - `disturb(space, size, design, random)`;
/// - `kDrawnStarts`, how many starts are drawn before any is a disturbed design;
/// - `kHopShare`, the share of the others that are;
/// - `search_fit` and `final_fit(space, design, deadline, work)`, a candidate.
template <class Method>
class HoppingExplorer {
 public:
  using Space = typename Method::Space;
  using Design = typename Method::Design;
  using Candidate = typename Method::Rules::Candidate;

  HoppingExplorer(const Space& space, std::size_t number, const Run& run, const Deadline& deadline,
                  const synthesis::WorkCounter& work)
      : space_(space),
        number_(number),
        run_(run),
        work_(work),
        search_({}, {run.threads, deadline, run.progress}) {}

  /// Fits designs known and adds them.
  void begin_with(const std::vector<Design>& known) {
    std::vector<Candidate> fresh(known.size());
    search_.for_each(known.size(), [&](std::size_t i) {
      fresh[i] = Method::search_fit(space_, known[i], search_.deadline(), work_);
    });
    search_.add(std::move(fresh), kSameHoppingDesign);
  }

  void explore(const synthesis::StartRule& rule, synthesis::Shares shares) {
    search_.explore(rule, shares, [&](int first, int count) { round(first, count); });
  }

  void finish(synthesis::Shares shares) {
    constexpr std::size_t kFinished = 6;  // of the designs found so many
    search_.keep(kFinished);
    search_.refine(shares, [&](Candidate& one) {
      Candidate finer = Method::final_fit(space_, one.design, search_.deadline(), work_);
      if (!search_.rules().has_value(finer)) return;
      finer.hits = one.hits;
      one = std::move(finer);
    });
    search_.merge(kSameHoppingDesign);
  }

  const synthesis::MultiStart<typename Method::Rules>& search() const { return search_; }
  const Space& space() const { return space_; }

 private:
  void round(int first, int count) {
    constexpr std::size_t kKept = 24;
    // Relative: of designs as close as that one alone is disturbed again, so that those kept lie in
    // different valleys.
    constexpr double kSameValley = 0.1;
    std::vector<Candidate> fresh(static_cast<std::size_t>(count));
    search_.for_each(fresh.size(), [&](std::size_t i) {
      const auto start_number = static_cast<std::uint64_t>(first) + std::uint64_t{i};
      std::seed_seq seed{run_.seed, std::uint64_t{number_}, start_number};
      std::mt19937_64 random(seed);
      if (const auto start = start_of(start_number, random)) {
        fresh[i] = Method::search_fit(space_, *start, search_.deadline(), work_);
      }
    });
    search_.add(std::move(fresh), kSameValley);
    search_.keep(kKept);
  }

  std::optional<Design> start_of(std::uint64_t number, std::mt19937_64& random) const {
    constexpr double kLeastHop = 3e-3, kMostHop = 0.5;
    const auto& all = search_.all();
    if (all.empty() || number < Method::kDrawnStarts ||
        uniform(random, 0, 1) >= Method::kHopShare) {
      return Method::draw(space_, random);
    }
    Design design = all[static_cast<std::size_t>(uniform(random, 0, double(all.size())))].design;
    const double size = std::exp(uniform(random, std::log(kLeastHop), std::log(kMostHop)));
    Method::disturb(space_, size, design, random);
    return design;
  }

  const Space& space_;
  std::size_t number_;
  const Run& run_;
  const synthesis::WorkCounter& work_;
  synthesis::MultiStart<typename Method::Rules> search_;
};

/// Searches go on while designs get better.
inline synthesis::StartRule hopping_rule(std::optional<int> starts, int fewest) {
  synthesis::StartRule rule;
  rule.starts = starts;
  rule.round = kHoppingRound;
  rule.fewest = fewest;
  rule.most = 4 * fewest;
  rule.enough_hits = 1;
  rule.patience = 1.6;
  rule.better_by = 0.01;
  rule.met = 1e-9;
  return rule;
}

}  // namespace cognate::problems
