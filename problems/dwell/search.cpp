#include "problems/dwell/search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/golden_section.hpp"
#include "analysis/numbers/random.hpp"
#include "problems/chain/cosine_scan.hpp"
#include "problems/chain/hopping_explorer.hpp"
#include "problems/dwell/starts.hpp"
#include "synthesis/chain/drawn.hpp"
#include "synthesis/optimise/solver.hpp"

namespace cognate::problems {
namespace {

constexpr int kSearchNodes = 17, kFinalNodes = 65;
constexpr int kSearchIterations = 60, kFinalIterations = 300;
constexpr int kSearchExchanges = 3, kFinalExchanges = 8;
constexpr double kFinalTolerance = 1e-9;
constexpr int kFewestStarts = 48 * kHoppingRound;
constexpr int kOutputSamples = 180, kExtremeSteps = 24;

struct Fitted : DwellFit {
  int hits = 1;
};

struct DwellRules {
  using Candidate = Fitted;

  bool has_value(const Candidate& one) const {
    return std::isfinite(one.half_band) && one.violation <= kDwellFeasibility;
  }
  bool precedes(const Candidate& a, const Candidate& b) const { return a.half_band < b.half_band; }
  double value(const Candidate& one) const { return one.half_band; }
  bool is_same(const Candidate& known, const Candidate& other, double tolerance) const {
    return is_same_chain(known.design.chain, other.design.chain, tolerance);
  }
};

/// Where the output is highest and lowest over the turn, between samples too, and what violates a
/// constraint most.
DwellChecks checks_of(const DwellSpace& space, const DwellDesign& design, double& violation) {
  DwellChecks checks;
  checks.transmission = CosineScan(space, design.chain).extremes({0, kTurn}, violation);
  const std::vector<double> side(design.chain.side.begin(), design.chain.side.end());
  FreeChain chain(space, design.chain.parameters, side);
  chain.at(0);
  const WantedOutput reference = space.output(chain);
  const auto output = [&](double crank) {
    chain.at(crank);
    return space.error(chain, reference);
  };
  double least = std::numeric_limits<double>::infinity(), greatest = -least;
  for (int i = 0; i < kOutputSamples; ++i) {
    const double crank = kTurn * i / kOutputSamples, here = output(crank);
    if (here < least) checks.lowest = crank;
    if (here > greatest) checks.highest = crank;
    least = std::min(least, here);
    greatest = std::max(greatest, here);
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
  if (!space.apart || dwells.size() != 2) return 0;
  constexpr int kSamples = 180;
  constexpr double kSampleError = 4e-3;
  const std::vector<double> side(here.design.chain.side.begin(), here.design.chain.side.end());
  FreeChain chain(space, here.design.chain.parameters, side);
  std::array<double, 2> middles;
  WantedOutput reference;
  for (std::size_t k = 0; k < 2; ++k) {
    double least = std::numeric_limits<double>::infinity(), greatest = -least;
    for (int i = 0; i <= kSamples; ++i) {
      chain.at(here.design.start[k] + dwells[k].over * i / kSamples);
      if (k == 0 && i == 0) reference = space.output(chain);
      const double output = space.error(chain, reference);
      least = std::min(least, output);
      greatest = std::max(greatest, output);
    }
    middles.at(k) = 0.5 * (least + greatest);
  }
  const double distance = std::abs(middles[1] - middles[0]) - kSampleError * here.half_band;
  return std::max(0.0, *space.apart - distance);
}

/// How a fit is made. From starts far from the limits more designs are found by SLSQP, which ends
/// far from the minimum in a narrow valley; the last fits are by Gauss-Newton.
struct Fitting {
  bool is_final;
  int exchanges;
  synthesis::Options options;

  int nodes() const { return is_final ? kFinalNodes : kSearchNodes; }
  synthesis::Solution minimum(const DwellModel& model, const synthesis::WorkCounter& work) const {
    const auto start = model.start();
    if (is_final) return minimum_within(model, start, options, kDwellFeasibility, work);
    const auto found = synthesis::solve(synthesis::Solver::slsqp, model, start, options);
    work.count(found);
    return found;
  }
};

Fitting search_fitting(const synthesis::Deadline& deadline, int exchanges) {
  return {false, exchanges, fit_options(deadline, kSearchIterations)};
}

Fitting final_fitting(const synthesis::Deadline& deadline, int exchanges, int iterations) {
  return {true, exchanges, fit_options(deadline, iterations, kFinalTolerance)};
}

/// Minimax fits from `start`, constraints asked anew where they are extreme, until none is violated
/// between.
Fitted fitted(const DwellSpace& space, const DwellDesign& start, const Fitting& how,
              const synthesis::WorkCounter& work) {
  Fitted here;
  here.design = start;
  double violation = 0;
  DwellChecks checks = checks_of(space, start, violation);
  std::vector<TransmissionCheck> watched;
  watch(space, checks.transmission, watched);
  double apart = space.apart.value_or(0);
  double unit = 0.01;
  for (int exchange = 0; exchange < how.exchanges; ++exchange) {
    checks.transmission = watched;
    checks.apart = apart;
    const DwellModel model(space, here.design, checks, how.nodes(), unit);
    const synthesis::Solution solution = how.minimum(model, work);
    if (solution.stop == synthesis::Stop::no_value || !std::isfinite(solution.objective)) break;
    here.design = model.design(solution.x);
    synthesis::draw_anew(space.lines, {1, 0}, here.design.chain);
    here.half_band = solution.objective * unit;
    unit = std::max(here.half_band, 1e-9);
    checks = checks_of(space, here.design, violation);
    const double missing = missing_distance(space, here);
    apart += missing;
    here.violation = std::max({violation, solution.violation, missing});
    if (here.violation <= kDwellFeasibility && exchange > 0) break;
    watch(space, checks.transmission, watched);
  }
  return here;
}

struct DwellMethod {
  using Space = DwellSpace;
  using Design = DwellDesign;
  using Rules = DwellRules;
  static constexpr std::uint64_t kDrawnStarts = 0;
  static constexpr double kHopShare = 0.85;  ///< to draw takes longer than to fit

  static std::optional<Design> draw(const Space& space, std::mt19937_64& random) {
    return draw_dwell(space, random);
  }

  static void disturb(const Space& space, double size, Design& design, std::mt19937_64& random) {
    problems::disturb(space, size, design.chain, random);
    for (std::size_t k = 0; k < design.start.size(); ++k) {
      if (!space.problem->dwells[k].from) design.start[k] += size * uniform(random, -1, 1);
    }
  }

  static Fitted search_fit(const Space& space, const Design& start,
                           const synthesis::Deadline& deadline,
                           const synthesis::WorkCounter& work) {
    return fitted(space, start, search_fitting(deadline, kSearchExchanges), work);
  }

  static Fitted final_fit(const Space& space, const Design& start,
                          const synthesis::Deadline& deadline, const synthesis::WorkCounter& work) {
    return fitted(space, start, final_fitting(deadline, kFinalExchanges, kFinalIterations), work);
  }
};

std::vector<DwellDesign> known_dwells(const DwellSpace& space, const std::vector<Design>& known) {
  std::vector<DwellDesign> starts;
  for (const auto& [chain, design] : known_chains(space, space.scale, known)) {
    std::vector<double> begins;  // of each dwell; its end follows
    for (std::size_t k = 0; k < design->crank_angles.size(); k += 2) {
      begins.push_back(design->crank_angles[k]);
    }
    if (begins.size() == space.problem->dwells.size()) starts.push_back({chain, std::move(begins)});
  }
  return starts;
}

}  // namespace

DwellFit fit_dwell(const DwellSpace& space, const DwellDesign& start, bool is_final,
                   const Deadline& deadline) {
  constexpr int kIterations = 60, kRounds = 4;
  const synthesis::WorkCounter unread;
  return fitted(
      space, start,
      is_final ? final_fitting(deadline, kRounds, kIterations) : search_fitting(deadline, kRounds),
      unread);
}

DwellSearchResult search_dwells(const std::vector<DwellSpace>& spaces, const Solve& options,
                                const Run& run, const Deadline& deadline, Work& work) {
  const synthesis::WorkCounter counter;
  const auto explorers = explored<HoppingExplorer<DwellMethod>>(
      spaces, [&](const DwellSpace& space) { return known_dwells(space, run.known); },
      hopping_rule(options.starts, kFewestStarts), run, deadline, counter);
  DwellSearchResult result;
  for (const auto& one : explorers) {
    for (const Fitted& found : one.search().all()) {
      result.designs.push_back({&one.space(), found.design, found.half_band, found.violation});
    }
  }
  std::ranges::stable_sort(result.designs, {}, &DwellMinimum::half_band);
  result.statistics = statistics_of(explorers, result.designs);
  count_work(counter, explorers, kSearchNodes, work);
  return result;
}

}  // namespace cognate::problems
