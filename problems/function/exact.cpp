#include "problems/function/exact.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "analysis/numbers/constants.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/function/designs.hpp"
#include "problems/function/exact_generators.hpp"
#include "problems/function/generator.hpp"
#include "problems/function/problem.hpp"
#include "problems/linkage/prevailing_side.hpp"
#include "problems/linkage/verify.hpp"

namespace cognate::problems {
namespace {

/// Output = `sense`·input + `offset`.
struct EqualTurning {
  double sense = 1;  ///< +1 or −1
  double offset = 0;
};

/// Angles that differ by less turn alike.
constexpr double kSameAngle = 1e-8;

/// Frame over crank: the shape of a parallelogram is free, a rhombus may fold onto itself.
constexpr double kFrameToCrank = 2;

bool turns(const FunctionSamples& wanted, const EqualTurning& turning) {
  const auto follows = [&](double input, double output) {
    return std::abs(wrapped(output - turning.sense * input - turning.offset)) <= kSameAngle;
  };
  for (const auto& pair : wanted.samples) {
    if (!follows(pair.input, pair.output)) return false;
  }
  for (const auto& point : wanted.precision) {
    if (!follows(point.input, point.output[0])) return false;
    for (std::size_t k = 1; k < point.multiplicity; ++k) {
      const double derivative = k == 1 ? turning.sense : 0;
      if (!(std::abs(point.output[k] - derivative) <= kSameAngle)) return false;
    }
  }
  return true;
}

/// The angle of `bounds` nearest to `angle`, whole turns aside.
double nearest_within(const std::optional<Range>& bounds, double angle) {
  if (!bounds) return angle;
  const double middle = 0.5 * (bounds->min + bounds->max);
  return std::clamp(middle + wrapped(angle - middle), bounds->min, bounds->max);
}

double within(const std::optional<Range>& bounds, double length) {
  return bounds ? std::clamp(length, bounds->min, bounds->max) : length;
}

Lengths<double> lengths_of(const FunctionProblem& problem) {
  const Given& given = problem.given;
  const double crank = given.crank.value_or(given.frame.value_or(kFrameToCrank) / kFrameToCrank);
  const double frame = given.frame.value_or(
      within(problem.bounds.frame, within(problem.bounds.coupler, kFrameToCrank * crank)));
  return {crank, frame, crank, frame};
}

/// How the output turns, where it turns by the input's angle at all of `wanted`, to 1e-8.
std::optional<EqualTurning> equal_turning(const FunctionSamples& wanted) {
  const auto& first = wanted.precision.front();
  for (const double sense : {1.0, -1.0}) {
    const EqualTurning turning{sense, wrapped(first.output[0] - sense * first.input)};
    if (turns(wanted, turning)) return turning;
  }
  return std::nullopt;
}

/// A parallelogram in the file's scale whose output turns with its input, `offset` ahead of it. A
/// start that is free is such that the input link stands across the frame in the middle of the
/// motion, or as near to it as its bounds allow; the frame, which may be of any length, is twice
/// the crank. Empty where the starts given differ by another angle.
std::optional<FunctionGenerator> parallelogram(const FunctionProblem& problem,
                                               const FunctionSamples& wanted, double offset) {
  const double across = kRightAngle - 0.5 * (wanted.sweep.min + wanted.sweep.max);
  FunctionGenerator generator;
  generator.links = lengths_of(problem);
  if (problem.input_start || !problem.output_start) {
    generator.input_start =
        problem.input_start.value_or(nearest_within(problem.input_start_bounds, across));
    generator.output_start = problem.output_start.value_or(
        nearest_within(problem.output_start_bounds, generator.input_start - offset));
    // Bounds on the output's start alone leave the input's to follow.
    if (!problem.input_start) generator.input_start = generator.output_start + offset;
  } else {
    generator.output_start = *problem.output_start;
    generator.input_start = generator.output_start + offset;
  }
  const double apart = wrapped(generator.input_start - generator.output_start - offset);
  return std::abs(apart) <= kSameAngle ? std::optional(generator) : std::nullopt;
}

/// What no four-bar does: why the given starts exclude a parallelogram, or that the output turns
/// the other way.
std::string equal_turning_note(const EqualTurning& turning) {
  if (turning.sense < 0) {
    return "The output turns by the angle of the input in the other sense: no four-bar with finite "
           "links does so exactly over a range, the limit being one with frame and coupler "
           "infinitely long; a pair of equal gears does.";
  }
  return fmt::format(
      "The output turns with the input by the same angle: any parallelogram does so, but it starts "
      "with input_start_deg = output_start_deg{}; leave one of the two out, or give them so.",
      std::abs(turning.offset) <= kSameAngle
          ? ""
          : fmt::format(" {} {:.10g}", turning.offset < 0 ? "-" : "+",
                        degrees(std::abs(turning.offset))));
}

/// Above it derivatives found numerically are no basis for a design.
constexpr double kDerivativeTolerance = 1e-4;

/// Best first: those that keep every constraint by their error, then the others by what they
/// violate. Of either those with links at the limit of length come last.
void sort_by_merit(std::vector<Design>& designs) {
  std::ranges::stable_sort(designs, [](const Design& a, const Design& b) {
    const auto rank = [](const Design& design) {
      return std::tuple(violation(design.constraints), is_limiting(design),
                        design.error.sum_of_squares);
    };
    return rank(a) < rank(b);
  });
}

/// How many of the solutions of the equations are real.
void note_real_ones(std::size_t real, std::size_t all, std::vector<std::string>& notes) {
  if (real == 0 && all > 1) {
    notes.push_back(
        fmt::format("None of the {} solutions is real: no mechanism passes through "
                    "these positions. Another start may have one.",
                    all == 3 ? "three" : "two"));
  } else if (real < all) {
    notes.push_back(fmt::format("{} of the {} solutions is real; the others are complex.",
                                real == 1 ? "One" : "Two", all == 3 ? "three" : "two"));
  }
}

/// How many solutions the equations have: a cubic where both starts are found, else a quadratic,
/// but linear equations where both starts are given, or a start displacement beside an offset.
std::size_t solution_count(const FunctionProblem& problem) {
  if (!problem.input_start && !problem.output_start) return 3;
  const bool linear = problem.offset ? problem.output_start.has_value()
                                     : problem.input_start && problem.output_start;
  return linear ? 1 : 2;
}

Result solve_for_points(const FunctionProblem& problem, const FunctionSamples& wanted) {
  Result result;
  auto found = exact_designs(problem, wanted, {problem.input_start, problem.output_start});
  result.designs = std::move(found.designs);
  result.notes = std::move(found.notes);
  sort_by_merit(result.designs);
  if (found.dependent) {
    result.notes.push_back(
        fmt::format("The {} do not determine a linkage: the equations for its ratios are "
                    "dependent to within rounding.",
                    conditions_in_words(wanted)));
  } else {
    note_real_ones(found.solutions, solution_count(problem), result.notes);
  }
  if (problem.spacing == PointSpacing::equal_peaks) level_peaks(problem, wanted, result);
  result.work.positions = result.designs.size() * (wanted.samples.size() + wanted.precision.size());
  return result;
}

/// The one design that is a parallelogram.
Result solve_by_parallelogram(const FunctionProblem& problem, const FunctionSamples& wanted,
                              FunctionGenerator generator) {
  const auto positions = sides_at(generator, wanted.precision);
  generator.assembly = prevailing_side(positions, &CrankPosition::side);
  std::vector<synthesis::AnglePair> pairs;
  for (const auto& point : wanted.precision) pairs.push_back({point.input, point.output[0]});
  Result result;
  Design design = function_design(problem, wanted, generator, positions, "exact:parallelogram");
  design.metrics.precision_residual = largest_error(generator, pairs, positions);
  result.designs.push_back(std::move(design));
  result.notes.push_back(
      "The output turns with the input by the same angle: any parallelogram does so exactly, "
      "for any frame, of which this one is an example. Where crank and frame lie in one line "
      "it may change into an antiparallelogram; start angles left free keep it away from there.");
  result.work.positions = wanted.samples.size() + wanted.precision.size();
  return result;
}

/// Linkages of which nothing but the conditions is known.
Result solve_conditions(const FunctionProblem& problem, const FunctionSamples& wanted, bool family,
                        const Deadline& deadline) {
  const auto turning = problem.type == MechanismType::four_bar ? equal_turning(wanted)
                                                               : std::optional<EqualTurning>{};
  if (turning && turning->sense > 0) {
    const auto generator = parallelogram(problem, wanted, turning->offset);
    if (generator) return solve_by_parallelogram(problem, wanted, *generator);
  }
  Result result =
      family ? solve_exact_family(problem, wanted, deadline) : solve_for_points(problem, wanted);
  if (turning) result.notes.push_back(equal_turning_note(*turning));
  return result;
}

}  // namespace

std::string conditions_in_words(const FunctionSamples& wanted) {
  const std::size_t count = condition_count(wanted.precision);
  const bool pairs = wanted.range.empty() && count == wanted.precision.size();
  return count_word(count) + (pairs ? " pairs" : " conditions");
}

std::string count_word(std::size_t count) {
  constexpr std::array<const char*, 6> kWords{"no", "one", "two", "three", "four", "five"};
  return kWords[std::min<std::size_t>(count, 5)];
}

void note_once(std::vector<std::string>& notes, std::string sentence) {
  if (std::ranges::count(notes, sentence) == 0) notes.push_back(std::move(sentence));
}

ExactDesigns exact_designs(const FunctionProblem& problem, const FunctionSamples& wanted,
                           const synthesis::GivenStart& start) {
  return problem.type == MechanismType::slider_crank ? exact_slider_cranks(problem, wanted, start)
                                                     : exact_four_bars(problem, wanted, start);
}

Result solve_exactly(const FunctionProblem& problem, const Deadline& deadline) {
  const FunctionSamples wanted = function_samples(problem);
  Result result;
  if (wanted.derivative_error > kDerivativeTolerance) {
    result.notes.push_back(
        "The function is not smooth at a precision point of higher multiplicity: its derivatives "
        "there cannot be found from its values. Give pairs with their derivatives instead.");
    return result;
  }
  const std::size_t unknown = (problem.offset ? 2 : 3) + std::size_t{!problem.input_start} +
                              std::size_t{!problem.output_start};
  const bool family = condition_count(wanted.precision) < unknown;
  result = solve_conditions(problem, wanted, family, deadline);
  note_designs(wanted, result);
  if (wanted.derivative_error > 0) {
    result.notes.push_back(fmt::format(
        "Derivatives of the function were found from its values, to {:.0e} of their size.",
        wanted.derivative_error));
  }
  if (deadline.reached() && family) {
    result.status = deadline.interrupted() ? Status::interrupted : Status::time_limit;
    return result;
  }
  if (result.designs.empty()) return result;
  result.status =
      all_satisfied(result.designs.front().constraints) ? Status::solved : Status::infeasible;
  return result;
}

}  // namespace cognate::problems
