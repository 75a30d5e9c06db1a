#include "problems/function/designs.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/linkage/cycle/cycle_metrics.hpp"
#include "problems/linkage/same_design.hpp"
#include "problems/linkage/verify.hpp"

namespace cognate::problems {
namespace {

/// Designs closer than this, relative to their size, are one.
constexpr double kSameWithin = 1e-3;

double ranked_error(const Design& design, FunctionObjective objective) {
  return objective == FunctionObjective::minimax ? design.error.max : design.error.sum_of_squares;
}

}  // namespace

void check_start_angle(std::vector<ConstraintCheck>& checks, const std::string& key, double angle,
                       const std::optional<double>& given, const std::optional<Range>& bounds) {
  if (given) {
    const double off = std::remainder(angle - *given, kTurn);
    checks.push_back({"mechanism." + key, degrees(*given + off), degrees(*given),
                      std::abs(off) <= kCheckTolerance});
  }
  if (bounds) {
    const double middle = 0.5 * (bounds->min + bounds->max);
    const double near = middle + std::remainder(angle - middle, kTurn);
    checks.push_back(
        {"bounds." + key, degrees(near), Range{degrees(bounds->min), degrees(bounds->max)},
         near >= bounds->min - kCheckTolerance && near <= bounds->max + kCheckTolerance});
  }
}

std::vector<CrankPosition> positions_of(const FunctionGenerator& generator,
                                        const std::vector<synthesis::AnglePair>& pairs) {
  std::vector<CrankPosition> positions;
  for (const auto& pair : pairs) {
    positions.push_back({in_one_turn(generator.input_start + pair.input), generator.assembly});
  }
  return positions;
}

std::vector<CrankPosition> sides_at(const FunctionGenerator& generator,
                                    const std::vector<synthesis::PrecisionPoint>& points) {
  const FourBar linkage = four_bar(generator);
  std::vector<CrankPosition> positions;
  for (const synthesis::PrecisionPoint& point : points) {
    const double input = generator.input_start + point.input;
    const double output = generator.output_start + point.output[0];
    const Vec2d b = linkage.crank * unit_vector(input);
    const Vec2d c = linkage.pivot_d + linkage.rocker * unit_vector(output);
    positions.push_back(position_of(linkage, b, c));
  }
  return positions;
}

std::optional<double> largest_error(FunctionGenerator generator,
                                    const std::vector<synthesis::AnglePair>& pairs,
                                    const std::vector<CrankPosition>& positions) {
  double largest = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    generator.assembly = positions[i].side;
    const auto error = StructuralError(generator).at(pairs[i]);
    if (!error) return std::nullopt;
    largest = std::max(largest, std::abs(*error));
  }
  return largest;
}

Design function_design(const FunctionProblem& problem, const FunctionSamples& wanted,
                       const FunctionGenerator& generator,
                       const std::vector<CrankPosition>& positions, std::string origin) {
  Design design;
  const FourBar linkage = four_bar(generator);
  design.mechanism = named(linkage);
  design.crank_angles.reserve(positions.size());
  for (const CrankPosition& position : positions) {
    design.crank_angles.push_back(in_one_turn(position.crank_angle));
  }
  design.error = StructuralError(generator).over(wanted);
  const CrankRange travel{generator.input_start + wanted.sweep.min,
                          generator.input_start + wanted.sweep.max};
  design.metrics = design_metrics(linkage, positions, {.timed = true, .travel = travel});
  design.metrics.input_start = in_one_turn(generator.input_start);
  design.metrics.output_start = in_one_turn(generator.output_start);
  add_cycle_metrics(problem.constraints, linkage, CycleOutput::rocker, design.metrics);
  design.constraints = check_constraints(problem.constraints, problem.bounds, problem.given,
                                         linkage, design.metrics);
  check_start_angle(design.constraints, "input_start_deg", generator.input_start,
                    problem.input_start, problem.input_start_bounds);
  check_start_angle(design.constraints, "output_start_deg", generator.output_start,
                    problem.output_start, problem.output_start_bounds);
  design.origin = std::move(origin);
  return design;
}

std::vector<Design> best_designs(std::vector<Design> designs,
                                 std::optional<FunctionObjective> objective, int count) {
  const auto sound = [](const Design& design) { return all_satisfied(design.constraints); };
  if (std::any_of(designs.begin(), designs.end(), sound)) {
    std::erase_if(designs, [&](const Design& design) { return !sound(design); });
    if (objective) {
      std::ranges::stable_sort(
          designs, {}, [&](const Design& design) { return ranked_error(design, *objective); });
    }
  } else {
    std::ranges::stable_sort(designs, {},
                             [](const Design& design) { return violation(design.constraints); });
  }
  std::vector<Design> best;
  for (Design& design : designs) {
    if (best.size() == static_cast<std::size_t>(count)) break;
    const bool known = std::any_of(best.begin(), best.end(), [&](const Design& other) {
      return same_design(four_bar(other), four_bar(design), kSameWithin);
    });
    if (!known) best.push_back(std::move(design));
  }
  return best;
}

}  // namespace cognate::problems
