/// @file Slider-cranks of a given time ratio and stroke.
///
/// The limits of the slider stand 2h = H apart on the slide line; the crank pivot sees them under θ
/// from the distance |e|. The geometry is that of the crank-rocker with its rocker's pivot at
/// infinity (see rocker.hpp): with q = (l₂/h)² − 1 and t = tan(θ/2)
///
///     (l₁/h)² = 1 − t² q,   |e| = h t q,   0 < q < q̂ = cos θ/sin²(θ/2),
///
/// at whose end the coupler stands across the slide: |e| < H cot θ, and K < 3. Offset and K = 1
/// exclude each other but for K = 1 without offset, where l₁ = h and the coupler is free.
#pragma once

#include <vector>

#include "analysis/linkage/slider_crank.hpp"
#include "analysis/linkage/slider_crank_mobility.hpp"
#include "synthesis/exact/quick_return/quick_return.hpp"

namespace cognate::synthesis {

/// What is desired: K ≥ 1 and the stroke > 0.
struct SliderTask {
  double time_ratio = 1;
  double stroke = 0;
};

/// A slider-crank with its pivot in the origin and its slide line along x, confirmed by the
/// analysis kernel from its dimensions alone.
struct QuickReturnSlider {
  SliderCrank mechanism;
  bool mirror = false;  ///< an image of the first: in the y axis, or in the slide line
  double outer = 0;     ///< crank angle with crank and coupler extended, from the x axis
  double inner = 0;     ///< folded
  double residual = 0;  ///< the larger of the errors of θ and of the stroke over the stroke
  double condition = 1;  ///< change of the pivot over l₂ with θ and with what was given; at least 1
  double pressure = 0;  ///< steepest pressure angle of the slider, radians
};

/// What leaves a whole curve of solutions, or none.
enum class SliderDegeneracy {
  none,
  any_coupler,  ///< K = 1, without offset or with the crank h: the coupler is free
  no_offset,    ///< K > 1 without offset: crank and coupler would both be h, the pivot at a limit
  no_quick      ///< K = 1 with an offset, which makes K > 1
};

/// All slider-cranks of a task, and what leaves a whole curve of them.
struct SliderSolutions {
  std::vector<QuickReturnSlider> designs;
  SliderDegeneracy degeneracy = SliderDegeneracy::none;
};

/// What dimensions there are for K < 3: strictly between these bounds (see ArcLimits).
struct SliderLimits {
  LengthInterval crank, coupler, offset;
};
SliderLimits slider_limits(const SliderTask& task);

/// The slider-crank with the offset given (positive: the slide line to the left of the pivot, seen
/// along x), then its image in the y axis.
SliderSolutions sliders_with_offset(const SliderTask& task, double offset);

/// The one with the crank, or the coupler, given; its offset positive, then its images.
SliderSolutions sliders_with_crank(const SliderTask& task, double crank);
SliderSolutions sliders_with_coupler(const SliderTask& task, double coupler);

/// The one whose steepest pressure angle is least, and its images: l₁ = u h with
///
///     u = (√(4 + 5 t²) − t)/2,   l₂ = h √(u/t),   |e| = h (u − t),   sin α = (2u − t) √(t/u),
///
/// the root other than u = t (α = 90°) of the derivative. At K = 1 it has an infinite coupler:
/// empty and `any_coupler`.
SliderSolutions best_sliders(const SliderTask& task);

}  // namespace cognate::synthesis
