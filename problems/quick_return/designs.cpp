#include "problems/quick_return/designs.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/linkage/four_bar.hpp"
#include "analysis/linkage/guide_bar_mobility.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/linkage/verify.hpp"

namespace cognate::problems {
namespace {

constexpr double kUnlimited = std::numeric_limits<double>::infinity();

void set_time_ratio(Design& design, double found, double wanted) {
  const double off = std::abs(found - wanted);
  design.metrics.time_ratio = found;
  design.error = {2 * off * off, off, off};  // at both limits
}

/// A slide takes the force as a rocker does whose transmission angle is 90° less the pressure
/// angle.
void set_pressure(Design& design, double least, double most, double steepest) {
  design.metrics.transmission_min = kRightAngle - most;
  design.metrics.transmission_max = kRightAngle - least;
  design.metrics.transmission_acute_min = kRightAngle - steepest;
  design.metrics.quantities.push_back({"pressure_angle_deg", degrees(steepest)});
}

void check_pressure(Design& design, const std::optional<double>& most, double steepest) {
  if (!most) return;
  design.constraints.push_back({"pressure_angle_deg_max", degrees(steepest),
                                Range{0, degrees(*most)}, steepest <= *most + kCheckTolerance});
}

void check_length(Design& design, const char* name, double value,
                  const std::optional<double>& given) {
  if (!given) return;
  const double size = std::max(std::abs(value), std::abs(*given));
  design.constraints.push_back(
      {name, value, *given, std::abs(value - *given) <= kCheckTolerance * size});
}

}  // namespace

synthesis::RockerTask rocker_task(const QuickReturnProblem& problem) {
  return {problem.time_ratio, *problem.given.rocker, *problem.swing};
}

Design quick_return_design(const QuickReturnProblem& problem,
                           const synthesis::QuickReturnRocker& found) {
  Design design;
  design.mechanism = named(found.linkage);
  design.crank_angles = {in_one_turn(found.outer), in_one_turn(found.inner)};
  design.metrics = design_metrics(found.linkage, design.crank_angles, {.order = PointOrder::any});
  set_time_ratio(design, *design.metrics.time_ratio, problem.time_ratio);
  design.metrics.precision_residual = found.residual;
  design.metrics.condition = found.condition;
  const Lengths<double> links = lengths(found.linkage);
  const double outer = std::abs(outer_limit(links)->rocker_angle),
               inner = std::abs(inner_limit(links)->rocker_angle);
  design.metrics.quantities.push_back({"swing_deg", degrees(std::abs(outer - inner))});
  design.metrics.quantities.push_back({"outer_limit_deg", degrees(outer)});
  design.metrics.quantities.push_back({"inner_limit_deg", degrees(inner)});
  design.metrics.quantities.push_back(
      {"crank_pivot_arc", std::string(found.arc == synthesis::PivotArc::near ? "near" : "far")});
  design.constraints = check_constraints(problem.constraints, problem.bounds, problem.given,
                                         found.linkage, design.metrics);
  if (problem.crank_pivot_line) {
    const auto& [a, b, c] = *problem.crank_pivot_line;
    const Vec2d& pivot = found.linkage.pivot_a;
    const double value = a * pivot.x + b * pivot.y;
    const double size = std::abs(a * pivot.x) + std::abs(b * pivot.y) + std::abs(c);
    design.constraints.push_back(
        {"mechanism.crank_pivot_line", value, c, std::abs(value - c) <= kCheckTolerance * size});
  }
  if (problem.limit_angle) {
    const auto& [limit, angle] = *problem.limit_angle;
    const double value = limit == synthesis::RockerLimit::outer ? outer : inner;
    design.constraints.push_back({fmt::format("mechanism.{}", limit_angle_key(limit)),
                                  degrees(value), degrees(angle),
                                  std::abs(value - angle) <= kCheckTolerance});
  }
  design.origin = "exact:quick-return";
  return design;
}

Design quick_return_design(const QuickReturnProblem& problem,
                           const synthesis::QuickReturnSlider& found) {
  const SliderCrank& mechanism = found.mechanism;
  Design design;
  design.mechanism = named(mechanism);
  design.crank_angles = {in_one_turn(found.outer), in_one_turn(found.inner)};
  design.metrics.change_point = is_change_point(mechanism);
  design.metrics.quantities = {{"class", std::string(name(mobility_class(mechanism)))},
                               {"stroke", *stroke(mechanism)}};
  set_time_ratio(design, *time_ratio(mechanism), problem.time_ratio);
  const auto pressure = pressure_angles(mechanism);
  set_pressure(design, pressure->min, pressure->max, pressure->steepest);
  design.metrics.precision_residual = found.residual;
  design.metrics.condition = found.condition;
  check_length(design, "mechanism.crank", mechanism.crank, problem.given.crank);
  check_length(design, "mechanism.coupler", mechanism.coupler, problem.given.coupler);
  check_length(design, "mechanism.offset", mechanism.offset, problem.offset);
  check_pressure(design, problem.pressure_angle_max, pressure->steepest);
  design.origin = "exact:quick-return";
  return design;
}

Design quick_return_design(const QuickReturnProblem& problem,
                           const synthesis::QuickReturnGuide& found) {
  const GuideBar& mechanism = found.mechanism;
  Design design;
  design.mechanism = named(mechanism);
  design.crank_angles = {found.right, found.left};
  design.metrics.change_point = is_change_point(mechanism);
  design.metrics.quantities = {{"class", std::string(name(mobility_class(mechanism)))},
                               {"swing_deg", degrees(*swing(mechanism))}};
  set_time_ratio(design, *time_ratio(mechanism), problem.time_ratio);
  const double steepest = *greatest_pressure_angle(mechanism);
  set_pressure(design, 0, steepest, steepest);
  design.metrics.precision_residual = found.residual;
  design.metrics.condition = found.condition;
  check_length(design, "mechanism.crank", mechanism.crank, problem.given.crank);
  check_length(design, "mechanism.frame", norm(mechanism.pivot_a - mechanism.pivot_c),
               problem.given.frame);
  design.origin = "exact:quick-return";
  return design;
}

Design quick_return_design(const QuickReturnProblem& problem, const synthesis::Shaper& found,
                           const synthesis::RamMotion& motion) {
  Design design;
  design.mechanism = named_shaper(found);
  design.crank_angles = {motion.right, motion.left};
  design.metrics.quantities = {{"class", std::string("oscillating")}, {"stroke", motion.stroke}};
  set_time_ratio(design, motion.time_ratio, problem.time_ratio);
  set_pressure(design, -found.pressure, found.pressure, found.pressure);
  design.metrics.precision_residual = std::abs(motion.stroke / *problem.stroke - 1);
  design.metrics.condition = 1;
  // On a raster the stroke is only approached.
  if (!problem.raster) check_length(design, "mechanism.stroke", motion.stroke, problem.stroke);
  check_pressure(design, problem.pressure_angle_max, found.pressure);
  // The block slides off a bar that ends before the crank's pin does.
  const double farthest = found.frame + found.crank;
  design.constraints.push_back({"bar", found.bar, Range{farthest, kUnlimited},
                                found.bar >= farthest * (1 - kCheckTolerance)});
  design.origin = "exact:quick-return";
  return design;
}

NamedMechanism named_shaper(const synthesis::Shaper& shaper) {
  constexpr int crank = 1, rod = 4, ram = 5;
  ChainDescription chain;
  chain.pivots = {{"A", {0, shaper.frame}}, {"C", {0, 0}}};
  chain.drive = CrankDescription{"A", "B", shaper.crank};
  DyadDescription guide;
  guide.type = DyadType::rpr;
  guide.joins = {"B", "C"};
  guide.names = {"block", "bar"};
  DyadDescription slide;
  slide.type = DyadType::rrp;
  slide.joins = {"D"};
  slide.lengths = {shaper.rod};
  slide.slides = {{Vec2d{0, shaper.ram_height}, kPi}};
  slide.new_point = "E";
  slide.names = {"rod", "ram"};
  chain.dyads = {guide, slide};

  NamedMechanism mechanism;
  mechanism.mechanism = synthesis::as_mechanism(shaper);
  mechanism.bodies = {"frame", "crank", "block", "bar", "rod", "ram"};
  mechanism.points = {{"A", {0, {0, shaper.frame}}},
                      {"C", {0, {0, 0}}},
                      {"B", {crank, {shaper.crank, 0}}},
                      {"E", {rod, {shaper.rod, 0}}}};
  add_point(mechanism, "D", "bar", {shaper.bar, 0});
  mechanism.output = ram;
  mechanism.description = chain;
  return mechanism;
}

}  // namespace cognate::problems
