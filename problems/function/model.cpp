#include "problems/function/model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/function/dead_centre.hpp"
#include "problems/function/extreme_crank_angle.hpp"
#include "problems/function/length_ranges.hpp"

namespace cognate::problems {
namespace {

using L = Lengths<double>;
constexpr std::array<double L::*, 4> kLinks{&L::crank, &L::coupler, &L::rocker, &L::frame};
constexpr std::array<const char*, 6> kNames{"crank", "coupler",     "rocker",
                                            "frame", "input_start", "output_start"};
/// How far solvers keep the transmission angle from 0 and 180°, in radians, where nothing else
/// limits it, so that what they find closes between the samples too; and the weight of that row: a
/// violation that counts as none is then 1e-14 of the cosine, less than the 4.5e-14 of the margin.
constexpr double kClosingMargin = 3e-7, kClosingWeight = 1e4;

double typical_length(const std::array<Range, 4>& ranges) {
  double logarithm = 0;
  int count = 0;
  for (const Range& range : ranges) {
    if (range.min != range.max) continue;
    logarithm += std::log(range.min);
    ++count;
  }
  return count > 0 ? std::exp(logarithm / count) : std::sqrt(ranges[0].min * ranges[0].max);
}

}  // namespace

FunctionModel::FunctionModel(const FunctionProblem& problem, const FunctionSamples& wanted,
                             Assembly assembly, synthesis::Objective objective, Closing closing)
    : problem_(problem),
      wanted_(wanted),
      assembly_(assembly),
      objective_(objective),
      linkage_constraints_(problem.constraints, typical_length(length_ranges(problem))),
      cycle_limits_(problem.constraints, CycleOutput::rocker) {
  list_variables();
  const bool limits_transmission =
      problem.constraints.transmission_angle && !linkage_constraints_.limits_transmission();
  const auto& required = problem.constraints.required_class;
  const bool crank_turns =
      required == RequiredClass::crank_rocker || required == RequiredClass::double_crank;
  const bool guards_closing = closing == Closing::guarded && !crank_turns;
  limits_sweep_ = limits_transmission || guards_closing;
  transmission_ = limits_transmission ? *problem.constraints.transmission_angle
                                      : Range{kClosingMargin, kPi - kClosingMargin};
  sweep_weight_ = limits_transmission ? 1 : kClosingWeight;
  for (const auto& pair : wanted.samples) half_input_.push_back(unit_vector(0.5 * pair.input));
}

void FunctionModel::list_variables() {
  const auto ranges = length_ranges(problem_);
  for (int i = 0; i < 4; ++i) {
    fixed_[i] = ranges[i].min;
    if (ranges[i].min == ranges[i].max) continue;
    free_.push_back(i);
    variables_.push_back({kNames[i], std::log(ranges[i].min), std::log(ranges[i].max), 1});
  }
  if (problem_.start != FunctionStart::free) return;
  const std::array given{problem_.input_start, problem_.output_start};
  const std::array bounds{problem_.input_start_bounds, problem_.output_start_bounds};
  for (int i = 0; i < 2; ++i) {
    fixed_[4 + i] = given[i].value_or(0);
    if (given[i]) continue;
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const Range range = bounds[i].value_or(Range{-infinite, infinite});
    free_.push_back(4 + i);
    variables_.push_back({kNames[4 + i], range.min, range.max, 1});
  }
}

synthesis::FunctionFit FunctionModel::lane_fit() const {
  synthesis::FunctionFit fit;
  fit.wanted = wanted_.samples;
  fit.free = free_;
  for (std::size_t i = 0; i < free_.size(); ++i) {
    const bool is_length = free_[i] < 4;
    fit.lower.push_back(is_length ? std::exp(variables_[i].lower) : variables_[i].lower);
    fit.upper.push_back(is_length ? std::exp(variables_[i].upper) : variables_[i].upper);
  }
  const auto limits = linkage_constraints_.limits();
  fit.limits.assign(limits.begin(), limits.end());
  if (limits_sweep_) {
    fit.transmission_cosine = {std::cos(transmission_.max), std::cos(transmission_.min)};
  }
  return fit;
}

int FunctionModel::constraint_count() const {
  return linkage_constraints_.count() + (limits_sweep_ ? 2 : 0) + cycle_limits_.count();
}

std::vector<double> FunctionModel::variables_of(const FunctionGenerator& generator) const {
  std::vector<double> x;
  for (std::size_t i = 0; i < free_.size(); ++i) {
    if (free_[i] < 4) {
      x.push_back(std::log(generator.links.*kLinks[free_[i]]));
    } else {
      const double angle = free_[i] == 4 ? generator.input_start : generator.output_start;
      const synthesis::Variable& v = variables_[i];
      const double middle =
          std::isfinite(v.lower) && std::isfinite(v.upper) ? 0.5 * (v.lower + v.upper) : 0;
      x.push_back(middle + wrapped(angle - middle));
    }
    x.back() = std::clamp(x.back(), variables_[i].lower, variables_[i].upper);
  }
  return x;
}

FunctionGenerator FunctionModel::generator(std::span<const double> x) const {
  FunctionGenerator result;
  std::array<double, kDimensions> full = fixed_;
  for (std::size_t i = 0; i < free_.size(); ++i) {
    full[free_[i]] = free_[i] < 4 ? std::exp(x[i]) : x[i];
  }
  result.links = {full[0], full[1], full[2], full[3]};
  result.assembly = assembly_;
  result.input_start = full[4];
  result.output_start = full[5];
  if (problem_.start == FunctionStart::free) return result;
  if (const auto dead = dead_centre(result.links, assembly_, problem_.start)) {
    result.input_start = dead->crank_angle;
    result.output_start = dead->rocker_angle;
  }
  return result;
}

/// Slopes of the start angles by the lengths; false where the linkage has no such start.
bool FunctionModel::set_start(FunctionGenerator& generator, L& input_slope, L& output_slope) const {
  if (problem_.start == FunctionStart::free) return true;
  const auto dead = dead_centre(generator.links, assembly_, problem_.start);
  if (!dead) return false;
  generator.input_start = dead->crank_angle;
  generator.output_start = dead->rocker_angle;
  input_slope = dead->crank_slope;
  output_slope = dead->rocker_slope;
  return true;
}

/// Derivatives by the free dimensions from those by the plain ones.
void FunctionModel::write_row(const Slopes& slopes, std::span<double> row) const {
  for (std::size_t i = 0; i < free_.size(); ++i) row[i] = slopes[free_[i]];
}

bool FunctionModel::residuals(std::span<const double> x, std::span<double> r,
                              std::span<double> jacobian, std::span<double>) const {
  FunctionGenerator g = generator(x);
  L input_slope, output_slope;
  if (!set_start(g, input_slope, output_slope)) return false;
  const Closure<double> closure(g.links);
  const Vec2d half_start = unit_vector(0.5 * g.input_start);
  for (std::size_t i = 0; i < wanted_.samples.size(); ++i) {
    const auto crank = crank_direction(half_start * half_input_[i]);
    const auto at = closure.at(crank, sign(assembly_));
    if (!(at.discriminant >= 0) || !std::isfinite(at.rocker.x)) return false;
    const double output = std::atan2(at.rocker.y, at.rocker.x);
    r[i] = wrapped(output - g.output_start - wanted_.samples[i].output);
    if (jacobian.empty()) continue;
    const auto slope = closure_gradient(g.links, Vec2d{crank.cos, crank.sin}, at).rocker;
    const std::array<double, 4> by_length{slope.crank, slope.coupler, slope.rocker, slope.frame};
    Slopes full{};
    for (int k = 0; k < 4; ++k) {
      full[k] = g.links.*kLinks[k] * (by_length[k] + slope.crank_angle * input_slope.*kLinks[k] -
                                      output_slope.*kLinks[k]);
    }
    full[4] = slope.crank_angle;
    full[5] = -1;
    write_row(full, jacobian.subspan(i * free_.size(), free_.size()));
  }
  return true;
}

/// Transmission over the sweep: cos μ = (l₂² + l₃² − d²)/(2 l₂ l₃) with d = |B − D| is extreme
/// where cos θ is.
void FunctionModel::sweep_constraints(const FunctionGenerator& g, std::span<double, 2> values,
                                      std::span<Slopes, 2> slopes) const {
  FunctionGenerator placed = g;
  L input_slope, output_slope;
  set_start(placed, input_slope, output_slope);
  const auto& [l1, l2, l3, l4] = g.links;
  for (int i = 0; i < 2; ++i) {
    const double sense = i == 0 ? 1 : -1;  // the least μ goes with the greatest cosine of θ
    const double limit = std::cos(i == 0 ? transmission_.min : transmission_.max);
    const double theta = extreme_crank_angle(wanted_.sweep, placed.input_start, sense).angle;
    const double c = std::cos(theta), s = std::sin(theta);
    const double diagonal = l1 * l1 + l4 * l4 - 2 * l1 * l4 * c;
    const double cosine = (l2 * l2 + l3 * l3 - diagonal) / (2 * l2 * l3);
    values[i] = sweep_weight_ * sense * (limit - cosine);
    const double by_angle = -l1 * l4 * s / (l2 * l3);
    const std::array plain{(l4 * c - l1) / (l2 * l3), 1 / l3 - cosine / l2, 1 / l2 - cosine / l3,
                           (l1 * c - l4) / (l2 * l3)};
    for (int k = 0; k < 4; ++k) {
      slopes[i][k] = -sweep_weight_ * sense * g.links.*kLinks[k] *
                     (plain[k] + by_angle * input_slope.*kLinks[k]);
    }
    slopes[i][4] = -sweep_weight_ * sense * by_angle;
    slopes[i][5] = 0;
  }
}

/// The rows of the limits over the turn: A is the origin, D lies on the x axis.
void FunctionModel::limit_turn(const FunctionGenerator& g, std::span<double> values,
                               std::span<double> jacobian) const {
  const auto count = static_cast<std::size_t>(cycle_limits_.count());
  std::vector<LimitSlopes> all(jacobian.empty() ? 0 : count);
  cycle_limits_.evaluate({.links = g.links, .assembly = assembly_}, values, all);
  for (std::size_t row = 0; row < all.size(); ++row) {
    Slopes slopes{};
    for (std::size_t k = 0; k < kLinks.size(); ++k) slopes[k] = g.links.*kLinks[k] * all[row][k];
    write_row(slopes, jacobian.subspan(row * free_.size(), free_.size()));
  }
}

void FunctionModel::constraints(std::span<const double> x, std::span<double> c,
                                std::span<double> jacobian) const {
  const FunctionGenerator g = generator(x);
  const auto of_lengths = static_cast<std::size_t>(linkage_constraints_.count());
  std::vector<L> gradient(jacobian.empty() ? 0 : of_lengths);
  linkage_constraints_.evaluate(g.links, c.first(of_lengths), gradient);
  for (std::size_t i = 0; i < gradient.size(); ++i) {
    Slopes slopes{};
    for (int k = 0; k < 4; ++k) slopes[k] = g.links.*kLinks[k] * gradient[i].*kLinks[k];
    write_row(slopes, jacobian.subspan(i * free_.size(), free_.size()));
  }
  const std::size_t before_turn = of_lengths + (limits_sweep_ ? 2 : 0);
  limit_turn(g, c.subspan(before_turn),
             jacobian.empty() ? jacobian : jacobian.subspan(before_turn * free_.size()));
  if (!limits_sweep_) return;
  std::array<Slopes, 2> slopes;
  sweep_constraints(g, c.subspan(of_lengths).first<2>(), slopes);
  for (std::size_t i = 0; i < 2 && !jacobian.empty(); ++i) {
    write_row(slopes[i], jacobian.subspan((of_lengths + i) * free_.size(), free_.size()));
  }
}

}  // namespace cognate::problems
