#include "problems/leg/search.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/random.hpp"
#include "problems/chain/topology_searches.hpp"
#include "problems/leg/fit.hpp"
#include "problems/leg/starts.hpp"
#include "problems/linkage/gait_quantities.hpp"

namespace cognate::problems {
namespace {

constexpr int kRound = 32;             ///< starts between two looks at what was found
constexpr std::size_t kKept = 24;      ///< designs kept while searching
constexpr std::size_t kFinished = 12;  ///< of which so many are finished with more nodes
/// Of the starts those that disturb a design found, of others those that are about a published leg.
constexpr double kHopShare = 0.5, kHopShareBesideKnown = 0.35, kKnownShare = 0.9;
constexpr double kScatteredShare = 0.6;  ///< of these such with its lengths alone
constexpr int kSearchNodes = 21, kFinalNodes = 65;
constexpr int kSearchIterations = 60, kFinalIterations = 120;
constexpr int kSearchExchanges = 3, kFinalExchanges = 30;
constexpr double kSameDesign = 0.02;  ///< relative: closer designs are one

struct LegRules {
  using Candidate = FittedLeg;
  double most_violation = kNearlyFeasibleLeg;

  bool has_value(const Candidate& one) const {
    return std::isfinite(one.objective) && one.violation <= most_violation;
  }
  bool precedes(const Candidate& a, const Candidate& b) const { return a.objective < b.objective; }
  double value(const Candidate& one) const { return one.objective; }
  bool is_same(const Candidate& known, const Candidate& other, double tolerance) const {
    return is_same_chain(known.design.chain, other.design.chain, tolerance);
  }
  /// The best, but half the places are for feasible ones: others may come to nothing.
  void keep(std::vector<Candidate>& sorted, std::size_t most) const {
    std::size_t feasible = 0, others = 0;
    const auto count = std::ranges::count_if(sorted, &Candidate::is_feasible);
    const std::size_t kept = std::min(most / 2, static_cast<std::size_t>(count));
    std::erase_if(sorted, [&](const Candidate& one) {
      const bool is_reserved = one.is_feasible && feasible < kept;
      ++(is_reserved ? feasible : others);
      return !is_reserved && others > most - kept;
    });
  }
};

/// The search of one topology.
class LegExplorer {
 public:
  LegExplorer(const LegSpace& space, std::size_t number, const Run& run, const Deadline& deadline,
              const synthesis::WorkCounter& work)
      : space_(space),
        number_(number),
        run_(run),
        work_(work),
        search_({}, {run.threads, deadline, run.progress}) {}

  /// Fits designs known and adds them.
  void begin_with(const std::vector<LegDesign>& known) {
    std::vector<FittedLeg> fresh;
    for (const LegDesign& one : known) {
      fresh.push_back(measured(space_, one.chain, one.span / kTurn));
      fresh.push_back(judged(space_, fitted_leg(space_, one, search_depth(), work_)));
    }
    search_.add(std::move(fresh), kSameDesign);
  }

  void explore(const synthesis::StartRule& rule, synthesis::Shares shares) {
    search_.explore(rule, shares, [&](int first, int count) { round(first, count); });
  }

  void finish(synthesis::Shares shares) {
    search_.keep(kFinished);
    search_.refine(shares, [&](FittedLeg& one) {
      const int hits = one.hits;
      const FitDepth depth{kFinalNodes, kFinalExchanges,
                           fit_options(search_.deadline(), kFinalIterations)};
      FittedLeg finer = judged(space_, fitted_leg(space_, one.design, depth, work_));
      const double duty = one.design.span / kTurn;
      FittedLeg before = one.is_feasible ? measured(space_, one.design.chain, duty) : FittedLeg{};
      one = is_better(before, finer) ? std::move(before) : std::move(finer);
      const bool finds_span = space_.problem->target.objective == LegObjective::duty;
      if (finds_span && one.is_feasible) one = lengthened(space_, one);
      one.hits = hits;
    });
    // Where time ended, designs that miss a limit by little are reported as such.
    if (!search_.is_over()) search_.rules().most_violation = kFeasibleLeg;
    search_.merge(kSameDesign);
  }

  const synthesis::MultiStart<LegRules>& search() const { return search_; }
  const LegSpace& space() const { return space_; }
  bool closes() const { return closes_; }

 private:
  void round(int first, int count) {
    std::vector<FittedLeg> fresh(static_cast<std::size_t>(count)), starts(fresh.size());
    search_.for_each(fresh.size(), [&](std::size_t i) {
      const auto number = static_cast<std::uint64_t>(first) + std::uint64_t{i};
      std::seed_seq seed{run_.seed, std::uint64_t{number_}, number};
      std::mt19937_64 random(seed);
      const auto start = start_of(number, random);
      if (!start) return;
      starts[i] = measured(space_, start->chain, start->span / kTurn);
      fresh[i] = judged(space_, fitted_leg(space_, *start, search_depth(), work_));
      // Where the two will be merged, one start led there.
      const LegRules& rules = search_.rules();
      const bool is_one = rules.has_value(fresh[i]) &&
                          is_same_chain(start->chain, fresh[i].design.chain, kSameDesign);
      starts[i].hits = is_one ? 0 : 1;
    });
    // A fit may run into dead points that its start is far from.
    for (std::size_t i = 0; i < starts.size(); ++i) {
      if (is_better(starts[i], fresh[i])) fresh.push_back(std::move(starts[i]));
    }
    closes_ = closes_ || std::ranges::any_of(fresh, [](const FittedLeg& one) {
                return std::isfinite(one.violation);
              });
    search_.add(std::move(fresh), kSameDesign);
    search_.keep(kKept);
  }

  FitDepth search_depth() const {
    return {kSearchNodes, kSearchExchanges, fit_options(search_.deadline(), kSearchIterations)};
  }

  std::optional<LegDesign> start_of(std::uint64_t number, std::mt19937_64& random) const {
    const auto& all = search_.all();
    if (space_.known && number == 0) return with_stance(space_, *space_.known);
    const double hops = space_.known ? kHopShareBesideKnown : kHopShare;
    if (!all.empty() && uniform(random, 0, 1) < hops) {
      const auto which = static_cast<std::size_t>(uniform(random, 0, double(all.size())));
      LegDesign design = all[which].design;
      const double size = disturb(design.chain, 1e-4, 0.3, random);
      design.start += size * uniform(random, -1, 1);
      return design;
    }
    if (space_.known && uniform(random, 0, 1) < kKnownShare) {
      if (uniform(random, 0, 1) < kScatteredShare) return draw_beside_known(space_, random);
      synthesis::ChainDesign chain = *space_.known;
      disturb(chain, 1e-3, 0.3, random);
      return with_stance(space_, std::move(chain));
    }
    return draw_leg(space_, random);
  }

  /// Changes all free dimensions by up to a share of them, drawn between these and returned.
  double disturb(synthesis::ChainDesign& chain, double least, double most,
                 std::mt19937_64& random) const {
    const double size = std::exp(uniform(random, std::log(least), std::log(most)));
    for (const int parameter : space_.free) {
      double& value = chain.parameters[static_cast<std::size_t>(parameter)];
      value += size * uniform(random, -1, 1) * std::max(0.1, std::abs(value));
    }
    return size;
  }

  const LegSpace& space_;
  std::size_t number_;
  const Run& run_;
  const synthesis::WorkCounter& work_;
  synthesis::MultiStart<LegRules> search_;
  bool closes_ = false;
};

synthesis::StartRule leg_rule(const Solve& options) {
  synthesis::StartRule rule;
  rule.starts = options.starts;
  rule.round = kRound;
  rule.fewest = 16 * kRound;
  rule.most = 96 * kRound;
  rule.enough_hits = 1;
  rule.patience = 1.6;
  rule.better_by = 0.01;
  rule.met = 1e-9;
  return rule;
}

std::vector<LegDesign> known_legs(const LegSpace& space, const std::vector<Design>& known) {
  std::vector<LegDesign> starts;
  for (const auto& [chain, design] : known_chains(space, space.scale, known)) {
    const auto duty = find_quantity(design->metrics.quantities, kDutyKey);
    const auto leg = duty ? with_stance(space, chain, *duty) : std::nullopt;
    if (leg) starts.push_back(*leg);
  }
  return starts;
}

}  // namespace

LegSearchResult search_legs(const std::vector<LegSpace>& spaces, const Solve& options,
                            const Run& run, const Deadline& deadline, Work& work) {
  const synthesis::WorkCounter counter;
  const auto explorers = explored<LegExplorer>(
      spaces, [&](const LegSpace& space) { return known_legs(space, run.known); },
      leg_rule(options), run, deadline, counter);
  LegSearchResult result;
  for (const LegExplorer& one : explorers) {
    result.closes = result.closes || one.closes();
    for (const FittedLeg& found : one.search().all()) {
      if (found.objective >= 1) continue;
      result.designs.push_back({&one.space(), found.design, found.objective});
    }
  }
  std::ranges::stable_sort(result.designs, {}, &LegMinimum::objective);
  result.statistics = statistics_of(explorers, result.designs);
  count_work(counter, explorers, kSearchNodes, work);
  return result;
}

}  // namespace cognate::problems
