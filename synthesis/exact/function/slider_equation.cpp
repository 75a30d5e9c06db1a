#include "synthesis/exact/function/slider_equation.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::synthesis {

SliderScale slider_scale(std::span<const PrecisionPoint> points, const GivenStart& start) {
  SliderScale scale;
  if (start.output) {
    scale.origin = -*start.output;
  } else {
    const auto [least, greatest] = std::ranges::minmax(
        points, {}, [](const PrecisionPoint& point) { return point.output[0]; });
    scale.origin = 0.5 * least.output[0] + 0.5 * greatest.output[0];
  }
  double size = 0;
  for (const PrecisionPoint& point : points) {
    size = std::max(size, std::abs(point.output[0] - scale.origin));
    for (std::size_t k = 1; k < point.multiplicity; ++k) {
      size = std::max(size, std::abs(point.output[k]));
    }
  }
  if (size > 0) scale.unit = size;
  return scale;
}

SliderRows slider_rows(std::span<const PrecisionPoint> points, const SliderScale& scale) {
  SliderRows rows;
  for (const PrecisionPoint& point : points) {
    const std::size_t count = point.multiplicity;
    RealSeries s = output_series(point);
    s[0] -= scale.origin;
    for (double& coefficient : s) coefficient /= scale.unit;
    const RealSeries square = product(s, s, count);
    const ComplexSeries u = direction_series({point.input, 1}, count);
    const ComplexSeries su = product(s, u, count);
    for (std::size_t k = 0; k < count; ++k) {
      rows.push_back({square[k], s[k], su[k], u[k], k == 0 ? 1.0 : 0.0});
    }
  }
  return rows;
}

SliderCrankOutcome infinite_slider_part(double h, double crank) {
  if (!(std::abs(h) > kInfiniteSliderRatio)) return SliderCrankOutcome::infinite_links;
  return std::abs(crank) > kInfiniteSliderRatio ? SliderCrankOutcome::linkage
                                                : SliderCrankOutcome::no_crank;
}

SliderCrankFunction slider_linkage(const SliderCoefficients& c, const SliderSetting& setting) {
  SliderCrankFunction result;
  const double unit = setting.scale.unit;
  const double offset = c.w / c.r;
  // The coupler in the first position: no difference of squares enters.
  const SliderRow& first = setting.rows[0];
  const Vec2d pin = c.r * (first.u * unit_vector(c.input_start));
  const double coupler = norm(Vec2d{first.s + c.output_start, offset} - pin);
  result.crank = unit * std::abs(c.r);
  result.offset = unit * offset;
  result.coupler = unit * coupler;
  if (!(coupler > kInfiniteSliderRatio * std::abs(c.r)))
    result.outcome = SliderCrankOutcome::no_coupler;
  result.input_turned = c.r < 0;
  result.input_start = c.input_start + (c.r < 0 ? kPi : 0);
  result.output_start = setting.start.output.value_or(unit * c.output_start - setting.scale.origin);
  if (!setting.start.input) result.input_turned = false;
  return result;
}

void add_slider_limit(SliderCrankOutcome outcome, double yoke_crank, SliderCrankFunctions& result) {
  SliderCrankFunction found;
  found.outcome = outcome;
  found.crank = yoke_crank;
  result.solutions.push_back(found);
}

}  // namespace cognate::synthesis
