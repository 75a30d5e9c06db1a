#include "synthesis/exact/quick_return/slider.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "analysis/numbers/constants.hpp"
#include "synthesis/exact/quick_return/pivot.hpp"

namespace cognate::synthesis {
namespace {

struct Slide {
  explicit Slide(const SliderTask& wanted)
      : task(wanted), h(0.5 * wanted.stroke), angle(return_angle(wanted.time_ratio)) {}

  double t() const { return angle.half_tangent(); }
  double end() const { return angle.cosine() / (angle.half_sine * angle.half_sine); }
  ArcPoint at(double q) const {
    return {std::sqrt(std::max(0.0, 1 - t() * t() * q)), std::sqrt(1 + q), t() * q};
  }

  SliderTask task;
  double h;
  ReturnAngle angle;
};

/// Errors of θ and of the stroke as the analysis kernel finds them, and what rounding explains.
bool confirm(const Slide& slide, QuickReturnSlider& design) {
  const auto ratio = time_ratio(design.mechanism);
  const auto travel = stroke(design.mechanism);
  const auto outer = outer_limit(design.mechanism), inner = inner_limit(design.mechanism);
  const auto pressure = pressure_angles(design.mechanism);
  if (!ratio || !travel || !outer || !inner || !pressure) return false;
  const double angle = kPi * (*ratio - 1) / (*ratio + 1);
  const double stroke_error = std::abs(*travel / slide.task.stroke - 1);
  design.residual = std::max(std::abs(angle - slide.angle.angle), stroke_error);
  design.outer = outer->crank_angle;
  design.inner = inner->crank_angle;
  design.pressure = pressure->steepest;
  const double folded = std::abs(inner->displacement);
  const double longest = design.mechanism.crank + design.mechanism.coupler;
  return design.residual <= 256 * kEpsilon * (1 + longest / folded);
}

/// The linkage and its images: `offset` with its sign, in both assemblies, and with the other sign
/// too where `both_offsets`.
SliderSolutions with_images(const Slide& slide, const ArcPoint& part, double condition,
                            bool negative, bool both_offsets) {
  SliderSolutions found;
  for (const double side : {1.0, -1.0}) {
    if (side < 0 && !both_offsets) break;
    for (const Assembly assembly : {Assembly::open, Assembly::crossed}) {
      QuickReturnSlider design;
      design.mechanism.crank = slide.h * part.crank;
      design.mechanism.coupler = slide.h * part.coupler;
      design.mechanism.offset = side * (negative ? -slide.h : slide.h) * part.height;
      design.mechanism.assembly = assembly;
      design.mirror = !found.designs.empty();
      design.condition = condition;
      if (confirm(slide, design)) found.designs.push_back(design);
    }
  }
  return found;
}

SliderSolutions degenerate(SliderDegeneracy why) {
  return {{}, why};
}

bool inside(const Slide& slide, double q) {
  return q > 0 && q < slide.end();
}

}  // namespace

SliderLimits slider_limits(const SliderTask& task) {
  const Slide slide(task);
  const double h = slide.h, t = slide.t();
  if (t == 0) return {{h, h}, {h, std::numeric_limits<double>::infinity()}, {0, 0}};
  return {{h * t, h}, {h, h / t}, {0, h * (1 - t) * (1 + t) / t}};
}

SliderSolutions sliders_with_offset(const SliderTask& task, double offset) {
  const Slide slide(task);
  const double t = slide.t();
  if (t == 0) {
    return degenerate(offset == 0 ? SliderDegeneracy::any_coupler : SliderDegeneracy::no_quick);
  }
  if (offset == 0) return degenerate(SliderDegeneracy::no_offset);
  const double q = std::abs(offset) / (slide.h * t);
  if (!inside(slide, q)) return {};
  ArcPoint part = slide.at(q);
  part.height = std::abs(offset) / slide.h;
  return with_images(slide, part, pivot_condition(part, PivotGiven::place, {0, 1 / part.height}),
                     offset < 0, false);
}

SliderSolutions sliders_with_crank(const SliderTask& task, double crank) {
  const Slide slide(task);
  const double t = slide.t(), u = crank / slide.h;
  if (t == 0) {
    const bool the_one = std::abs(u - 1) <= 16 * kEpsilon;
    return the_one ? degenerate(SliderDegeneracy::any_coupler) : SliderSolutions{};
  }
  const double q = (1 - u) * (1 + u) / (t * t);
  if (!inside(slide, q)) return {};
  ArcPoint part = slide.at(q);
  part.crank = u;
  return with_images(slide, part, pivot_condition(part, PivotGiven::crank), false, true);
}

SliderSolutions sliders_with_coupler(const SliderTask& task, double coupler) {
  const Slide slide(task);
  const double v = coupler / slide.h, q = (v - 1) * (v + 1);
  if (!(q > 0) || (slide.t() > 0 && !inside(slide, q))) return {};
  ArcPoint part = slide.at(q);
  part.coupler = v;
  return with_images(slide, part, pivot_condition(part, PivotGiven::coupler), false, slide.t() > 0);
}

SliderSolutions best_sliders(const SliderTask& task) {
  const Slide slide(task);
  const double t = slide.t();
  if (t == 0) return degenerate(SliderDegeneracy::any_coupler);
  if (!(t < 1)) return {};
  // u − t without cancellation as t → 1: u² + t u = 1 + t² gives (u − t)(u + 2t) = 1 − t².
  const double u = 0.5 * (std::sqrt(4 + 5 * t * t) - t);
  const double offset = (1 - t) * (1 + t) / (u + 2 * t);
  const ArcPoint part{u, std::sqrt(u / t), offset};
  return with_images(slide, part, pivot_condition(part, PivotGiven::coupler), false, true);
}

}  // namespace cognate::synthesis
