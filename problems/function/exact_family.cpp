#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/function/exact.hpp"
#include "problems/function/exact_generators.hpp"
#include "problems/function/family_table.hpp"
#include "problems/linkage/verify.hpp"
#include "synthesis/exact/in_place_vector.hpp"

namespace cognate::problems {
namespace {

using synthesis::GivenStart;

constexpr int kLineSamples = 360;     ///< of a family on one number
constexpr int kPlaneSamples = 60;     ///< of each of two numbers
constexpr int kMostRefined = 24;      ///< local minima among the samples that are refined
constexpr double kLeastStep = 1e-10;  ///< of a start angle, at which refinement ends
constexpr int kMostMoves = 300;       ///< after which every further step is a shorter one

/// Designs whose lengths agree so far are one.
constexpr double kSameMember = 1e-4;

/// A place in the family: the coordinates of the starts that are free, angles or the arctangents of
/// displacements.
using Place = std::array<double, 2>;

/// How good a design is: the lesser the better, what it violates first.
struct FamilyScore {
  double violation = kInfinity;
  bool limiting = true;  ///< links so long that they are those of a slider
  double score = kInfinity;

  friend bool operator<(const FamilyScore& a, const FamilyScore& b) {
    return std::tie(a.violation, a.limiting, a.score) < std::tie(b.violation, b.limiting, b.score);
  }
};

struct Candidate {
  Place place{};
  Design design;
  FamilyScore merit;
};

bool by_merit(const Candidate& a, const Candidate& b) {
  return a.merit < b.merit;
}

/// One start that is free.
struct FreeStart {
  bool input = true;
  bool angle = true;  ///< else a displacement
  Range range;        ///< of the coordinate
  bool periodic = false;
};

class FamilySearch {
 public:
  FamilySearch(const FunctionProblem& problem, const FunctionSamples& wanted,
               const Deadline& deadline)
      : problem_(problem), wanted_(wanted), deadline_(deadline) {
    const std::size_t missing = std::size_t{!problem.input_start} + !problem.output_start;
    const std::size_t lengths = problem.offset ? 2 : 3;
    const std::size_t dimension = lengths + missing - condition_count(wanted.precision);
    // Where one of two free starts follows from the conditions, the input is the one to choose.
    if (!problem.input_start) free_.push_back(free_start(true));
    if (!problem.output_start && free_.size() < dimension) free_.push_back(free_start(false));
    set_displacement_unit();
  }

  Result solve();

 private:
  FreeStart free_start(bool input) const;
  void set_displacement_unit();
  int samples_each() const { return free_.size() == 1 ? kLineSamples : kPlaneSamples; }
  double coordinate(std::size_t i, int sample) const {
    const Range& range = free_[i].range;
    return range.min + (range.max - range.min) * (sample + 0.5) / samples_each();
  }
  double start_value(const FreeStart& start, double coordinate) const {
    return start.angle ? coordinate : middle_ + unit_ * std::tan(coordinate);
  }
  GivenStart start_at(const Place& place) const;
  FamilyScore merit(const Design& design) const;
  std::vector<Candidate> candidates_at(const Place& place);
  Candidate refined(Candidate best);
  void add_tables(const std::vector<std::vector<Candidate>>& line, Result& result) const;
  std::vector<Candidate> local_minima(const std::vector<std::vector<Candidate>>& samples,
                                      int rows) const;
  std::vector<Design> distinct(std::vector<Candidate> candidates) const;

  const FunctionProblem& problem_;
  const FunctionSamples& wanted_;
  const Deadline& deadline_;
  synthesis::InPlaceVector<FreeStart, 2> free_;
  double middle_ = 0, unit_ = 1;  ///< of displacements
  std::uint64_t evaluated_ = 0;
};

FreeStart FamilySearch::free_start(bool input) const {
  const bool slider = problem_.type == MechanismType::slider_crank;
  const auto& bounds = input ? problem_.input_start_bounds : problem_.output_start_bounds;
  if (slider && !input) return {false, false, {-kRightAngle, kRightAngle}, false};
  if (bounds && bounds->max - bounds->min < kPi) return {input, true, *bounds, false};
  return {input, true, {0, kPi}, true};
}

void FamilySearch::set_displacement_unit() {
  const auto [least, greatest] =
      std::ranges::minmax(wanted_.precision, {}, [](const auto& point) { return point.output[0]; });
  middle_ = -0.5 * (least.output[0] + greatest.output[0]);
  unit_ = 2 * (greatest.output[0] - least.output[0]);
  if (const auto& bounds = problem_.output_start_bounds;
      bounds && std::isfinite(bounds->max - bounds->min)) {
    middle_ = 0.5 * (bounds->min + bounds->max);
    unit_ = 0.5 * (bounds->max - bounds->min);
  }
  if (!(unit_ > 0)) unit_ = 1;
}

GivenStart FamilySearch::start_at(const Place& place) const {
  GivenStart start{problem_.input_start, problem_.output_start};
  for (std::size_t i = 0; i < free_.size(); ++i) {
    (free_[i].input ? start.input : start.output) = start_value(free_[i], place[i]);
  }
  return start;
}

FamilyScore FamilySearch::merit(const Design& design) const {
  const bool by_error =
      problem_.best_by.value_or(std::holds_alternative<FunctionOfX>(problem_.target)
                                    ? BestBy::error
                                    : BestBy::transmission) == BestBy::error;
  return {violation(design.constraints), is_limiting(design),
          by_error ? design.error.max : -design.metrics.transmission_acute_min};
}

std::vector<Candidate> FamilySearch::candidates_at(const Place& place) {
  std::vector<Candidate> candidates;
  for (Design& design : exact_designs(problem_, wanted_, start_at(place)).designs) {
    const FamilyScore own = merit(design);
    candidates.push_back({place, std::move(design), own});
  }
  ++evaluated_;
  return candidates;
}

/// A search along the coordinates whose step halves where nothing near is better.
Candidate FamilySearch::refined(Candidate best) {
  const double first = (free_[0].range.max - free_[0].range.min) / samples_each();
  int moves = 0;
  for (double step = first; step > kLeastStep && !deadline_.reached();) {
    bool better = false;
    for (std::size_t i = 0; i < free_.size(); ++i) {
      for (const double sense : {-1.0, 1.0}) {
        Place place = best.place;
        place[i] += sense * step;
        const bool inside = place[i] >= free_[i].range.min && place[i] <= free_[i].range.max;
        if (!inside && !free_[i].periodic) continue;
        for (Candidate& next : candidates_at(place)) {
          if (!(next.merit < best.merit)) continue;
          best = std::move(next);
          better = true;
        }
      }
    }
    if (!better || ++moves > kMostMoves) step *= 0.5;
  }
  return best;
}

std::vector<Design> FamilySearch::distinct(std::vector<Candidate> candidates) const {
  std::ranges::stable_sort(candidates, by_merit);
  std::vector<Design> designs;
  for (Candidate& candidate : candidates) {
    if (designs.size() == static_cast<std::size_t>(problem_.solve.designs)) break;
    const bool known = std::ranges::any_of(designs, [&](const Design& other) {
      return same_lengths(other, candidate.design, kSameMember);
    });
    if (!known) designs.push_back(std::move(candidate.design));
  }
  return designs;
}

void FamilySearch::add_tables(const std::vector<std::vector<Candidate>>& line,
                              Result& result) const {
  FamilyTable table(problem_, free_[0].input, free_[0].angle);
  for (std::size_t i = 0; i < line.size(); ++i) {
    const double start = start_value(free_[0], coordinate(0, static_cast<int>(i)));
    std::vector<const Design*> designs;
    for (const Candidate& candidate : line[i]) designs.push_back(&candidate.design);
    table.add(start, designs);
  }
  result.families = table.families();
}

/// The best of each sample that no neighbouring sample, across the seam of an angle too, surpasses.
std::vector<Candidate> FamilySearch::local_minima(
    const std::vector<std::vector<Candidate>>& samples, int rows) const {
  const int columns = samples_each();
  // A deadline may have cut the samples short: those behind have none.
  const auto size = static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns);
  std::vector<const Candidate*> best(size, nullptr);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    for (const Candidate& candidate : samples[i]) {
      if (!best[i] || candidate.merit < best[i]->merit) best[i] = &candidate;
    }
  }
  const auto at = [&](int row, int column) {
    const int index = ((row + rows) % rows) * columns + (column + columns) % columns;
    return best[static_cast<std::size_t>(index)];
  };
  std::vector<Candidate> minima;
  for (int i = 0; i < static_cast<int>(best.size()); ++i) {
    const Candidate* own = at(i / columns, i % columns);
    bool least = own != nullptr;
    for (int k = 0; least && k < 9; ++k) {
      const Candidate* other = at(i / columns + k / 3 - 1, i % columns + k % 3 - 1);
      least = !other || !(other->merit < own->merit);
    }
    if (least) minima.push_back(*own);
  }
  return minima;
}

Result FamilySearch::solve() {
  Result result;
  const int each = samples_each();
  const int rows = free_.size() == 1 ? 1 : each;
  std::vector<std::vector<Candidate>> samples;
  for (int i = 0; i < rows * each && !deadline_.reached(); ++i) {
    const Place place{coordinate(0, i % each), rows == 1 ? 0 : coordinate(1, i / each)};
    samples.push_back(candidates_at(place));
  }
  if (free_.size() == 1) add_tables(samples, result);
  std::vector<Candidate> best = local_minima(samples, rows);
  std::ranges::stable_sort(best, by_merit);
  if (best.size() > kMostRefined) best.resize(kMostRefined);
  for (Candidate& candidate : best) candidate = refined(std::move(candidate));
  result.designs = distinct(std::move(best));
  result.work.candidates = evaluated_;
  result.work.positions = evaluated_ * wanted_.samples.size();
  if (result.designs.empty()) {
    result.notes.push_back(
        fmt::format("No start that was tried gives a real mechanism through the {}.",
                    conditions_in_words(wanted_)));
  } else {
    result.notes.push_back(
        fmt::format("{} conditions leave {} free: members of the family were sampled at {} places.",
                    condition_count(wanted_.precision),
                    free_.size() == 2 ? "two numbers" : "one number", evaluated_));
  }
  return result;
}

}  // namespace

Result solve_exact_family(const FunctionProblem& problem, const FunctionSamples& wanted,
                          const Deadline& deadline) {
  return FamilySearch(problem, wanted, deadline).solve();
}

}  // namespace cognate::problems
