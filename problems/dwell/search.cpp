#include "problems/dwell/search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <list>

#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/golden_section.hpp"
#include "analysis/numbers/random.hpp"
#include "problems/chain/cosine_scan.hpp"
#include "problems/dwell/starts.hpp"
#include "synthesis/optimise/solver.hpp"

namespace cognate::problems {
namespace {

constexpr int kRound = 64;            ///< starts between two looks at what was found
constexpr std::size_t kKept = 24;     ///< designs kept while searching
constexpr std::size_t kFinished = 6;  ///< of which so many are finished with more nodes
constexpr double kHopShare = 0.7;     ///< of the starts that disturb a design known
constexpr int kSearchNodes = 17, kFinalNodes = 65;
constexpr double kAllowed = 1e-7;     ///< violation of a constraint that is none
constexpr double kSameDesign = 0.02;  ///< relative: closer designs are one
constexpr int kOutputSamples = 180, kExtremeSteps = 24;

struct Fitted {
  DwellDesign design;
  double half_band = std::numeric_limits<double>::infinity();
  double violation = std::numeric_limits<double>::infinity();
  int hits = 1;
};

struct DwellRules {
  using Candidate = Fitted;

  bool has_value(const Candidate& one) const {
    return std::isfinite(one.half_band) && one.violation <= kAllowed;
  }
  bool precedes(const Candidate& a, const Candidate& b) const { return a.half_band < b.half_band; }
  double value(const Candidate& one) const { return one.half_band; }
  bool is_same(const Candidate& known, const Candidate& other, double tolerance) const {
    if (known.design.chain.side != other.design.chain.side) return false;
    const auto& a = known.design.chain.parameters;
    const auto& b = other.design.chain.parameters;
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (std::abs(a[i] - b[i]) > tolerance * std::max(1.0, std::abs(a[i]))) return false;
    }
    return true;
  }
};

/// Where the output is highest and lowest over the turn, between samples too, and what violates a
/// constraint most.
DwellChecks checks_of(const DwellSpace& space, const DwellDesign& design, double& violation) {
  DwellChecks checks;
  checks.transmission = CosineScan(space, design.chain).extremes({0, kTurn}, violation);
  const std::vector<double> side(design.chain.side.begin(), design.chain.side.end());
  FreeChain chain(space, design.chain.parameters, side);
  Vec2d reference;
  const auto output = [&](double crank) {
    const Vec2d* at = chain.at(crank);
    const Vec2d way = at[space.to] - at[space.from];
    if (reference == Vec2d{}) reference = way;
    return relative_angle(way, reference);
  };
  double least = std::numeric_limits<double>::infinity(), greatest = -least;
  for (int i = 0; i < kOutputSamples; ++i) {
    const double crank = kTurn * i / kOutputSamples, angle = output(crank);
    if (angle < least) checks.lowest = crank;
    if (angle > greatest) checks.highest = crank;
    least = std::min(least, angle);
    greatest = std::max(greatest, angle);
  }
  constexpr double kStep = kTurn / kOutputSamples;
  const auto refined = [&](double crank, double sense) {
    const auto lowered = [&](double at) { return -sense * output(at); };
    return golden_section(lowered, crank - kStep, crank + kStep, kExtremeSteps).middle();
  };
  checks.lowest = refined(checks.lowest, -1);
  checks.highest = refined(checks.highest, 1);
  const double swing = output(checks.highest) - output(checks.lowest);
  violation = std::max(violation, space.swing_min - swing);
  if (!std::isfinite(swing)) violation = std::numeric_limits<double>::infinity();
  return checks;
}

/// By how much the middles of the output in two dwells are nearer than wanted; the samples' own
/// error, a small part of the half band, counts as such.
double missing_distance(const DwellSpace& space, const Fitted& here) {
  const auto& dwells = space.problem->dwells;
  if (!space.problem->apart || dwells.size() != 2) return 0;
  constexpr int kSamples = 180;
  constexpr double kSampleError = 4e-3;
  const std::vector<double> side(here.design.chain.side.begin(), here.design.chain.side.end());
  FreeChain chain(space, here.design.chain.parameters, side);
  std::array<double, 2> middles;
  Vec2d reference;
  for (std::size_t k = 0; k < 2; ++k) {
    double least = std::numeric_limits<double>::infinity(), greatest = -least;
    for (int i = 0; i <= kSamples; ++i) {
      const Vec2d* at = chain.at(here.design.start[k] + dwells[k].over * i / kSamples);
      const Vec2d way = at[space.to] - at[space.from];
      if (k == 0 && i == 0) reference = way;
      least = std::min(least, relative_angle(way, reference));
      greatest = std::max(greatest, relative_angle(way, reference));
    }
    middles.at(k) = 0.5 * (least + greatest);
  }
  const double distance = std::abs(middles[1] - middles[0]) - kSampleError * here.half_band;
  return std::max(0.0, *space.problem->apart - distance);
}

/// Minimax fits from `start`, constraints asked anew where they are extreme, until none is violated
/// between.
Fitted fitted(const DwellSpace& space, const DwellDesign& start, int nodes, int exchanges,
              const synthesis::Options& options, const synthesis::WorkCounter& work) {
  Fitted here{start};
  double violation = 0;
  DwellChecks checks = checks_of(space, start, violation);
  std::vector<TransmissionCheck> watched = checks.transmission;
  double apart = space.problem->apart.value_or(0);
  double unit = 0.01;
  for (int exchange = 0; exchange < exchanges; ++exchange) {
    checks.transmission = watched;
    checks.apart = apart;
    const DwellModel model(space, here.design, checks, nodes, unit);
    const auto x = model.start();
    const synthesis::Solution solution =
        synthesis::solve(synthesis::Solver::slsqp, model, x, options);
    work.count(solution);
    if (solution.stop == synthesis::Stop::no_value || !std::isfinite(solution.objective)) break;
    here.design = model.design(solution.x);
    here.half_band = solution.objective * unit;
    unit = std::max(here.half_band, 1e-9);
    checks = checks_of(space, here.design, violation);
    const double missing = missing_distance(space, here);
    apart += missing;
    here.violation = std::max({violation, solution.violation, missing});
    if (here.violation <= kAllowed && exchange > 0) break;
    watched.insert(watched.end(), checks.transmission.begin(), checks.transmission.end());
  }
  return here;
}

/// The search of one topology.
class DwellExplorer {
 public:
  DwellExplorer(const DwellSpace& space, std::size_t number, const Run& run,
                const Deadline& deadline, const synthesis::WorkCounter& work)
      : space_(space),
        number_(number),
        run_(run),
        work_(work),
        search_({}, {run.threads, deadline, run.progress}) {}

  void explore(const synthesis::StartRule& rule, synthesis::Shares shares) {
    search_.explore(rule, shares, [&](int first, int count) { round(first, count); });
  }

  void finish(synthesis::Shares shares) {
    search_.keep(kFinished);
    search_.refine(shares, [&](Fitted& one) {
      const Fitted finer = fitted(space_, one.design, kFinalNodes, 8, options(300), work_);
      if (finer.violation <= kAllowed) {
        const int hits = one.hits;
        one = finer;
        one.hits = hits;
      }
    });
    search_.merge(kSameDesign);
  }

  const synthesis::MultiStart<DwellRules>& search() const { return search_; }
  const DwellSpace& space() const { return space_; }

 private:
  synthesis::Options options(int iterations) const {
    synthesis::Options own;
    own.tolerance = 1e-9;
    own.feasibility = 1e-9;
    own.max_iterations = iterations;
    return synthesis::until(search_.deadline(), own);
  }

  void round(int first, int count) {
    std::vector<Fitted> fresh(static_cast<std::size_t>(count));
    search_.for_each(fresh.size(), [&](std::size_t i) {
      std::seed_seq seed{run_.seed, std::uint64_t{number_},
                         static_cast<std::uint64_t>(first) + std::uint64_t{i}};
      std::mt19937_64 random(seed);
      const bool hop = !search_.all().empty() && uniform(random, 0, 1) < kHopShare;
      const auto start = hop ? std::optional(disturbed(random)) : draw_dwell(space_, random);
      if (start) fresh[i] = fitted(space_, *start, kSearchNodes, 3, options(60), work_);
    });
    search_.add(std::move(fresh), kSameDesign);
    search_.keep(kKept);
  }

  DwellDesign disturbed(std::mt19937_64& random) const {
    const auto& all = search_.all();
    const auto which = static_cast<std::size_t>(uniform(random, 0, double(all.size())));
    DwellDesign design = all[which].design;
    const double size = std::exp(uniform(random, std::log(1e-4), std::log(0.15)));
    for (const int parameter : space_.free) {
      double& value = design.chain.parameters[static_cast<std::size_t>(parameter)];
      value += size * uniform(random, -1, 1) * std::max(0.3, std::abs(value));
    }
    for (std::size_t k = 0; k < design.start.size(); ++k) {
      if (!space_.problem->dwells[k].from) design.start[k] += size * uniform(random, -1, 1);
    }
    return design;
  }

  const DwellSpace& space_;
  std::size_t number_;
  const Run& run_;
  const synthesis::WorkCounter& work_;
  synthesis::MultiStart<DwellRules> search_;
};

synthesis::StartRule dwell_rule(const Solve& options) {
  synthesis::StartRule rule;
  rule.starts = options.starts;
  rule.round = kRound;
  rule.fewest = 24 * kRound;
  rule.most = 96 * kRound;
  rule.enough_hits = 1;
  rule.patience = 1.6;
  rule.better_by = 0.01;
  rule.met = 1e-9;
  return rule;
}

}  // namespace

DwellSearchResult search_dwells(const std::vector<DwellSpace>& spaces, const Solve& options,
                                const Run& run, const Deadline& deadline, Work& work) {
  const synthesis::WorkCounter counter;
  std::list<DwellExplorer> explorers;
  DwellSearchResult result;
  const double step = 1.0 / double(spaces.size());
  double share = 0;
  for (const DwellSpace& space : spaces) {
    auto& one = explorers.emplace_back(space, explorers.size(), run, deadline, counter);
    one.explore(dwell_rule(options), {share, share + 0.9 * step});
    one.finish({share + 0.9 * step, share + step});
    share += step;
    for (const Fitted& found : one.search().all()) {
      result.designs.push_back({&space, found.design, found.half_band, found.violation});
    }
  }
  std::ranges::stable_sort(result.designs, {}, &DwellMinimum::half_band);
  for (const DwellExplorer& one : explorers) {
    work.candidates += static_cast<std::uint64_t>(one.search().starts());
    if (result.designs.empty() || &one.space() != result.designs.front().space) continue;
    result.statistics = one.search().statistics(synthesis::kBestMinima);
  }
  work.positions += counter.total().evaluations * kSearchNodes;
  work.gradients += counter.total().gradients;
  work.solver_iterations += counter.total().iterations;
  return result;
}

}  // namespace cognate::problems
