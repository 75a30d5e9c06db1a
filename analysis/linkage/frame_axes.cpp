#include "analysis/linkage/frame_axes.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/long_length.hpp"

namespace cognate {

FrameAxes::FrameAxes(const FourBar& linkage) {
  const Vec2d &a = linkage.pivot_a, &d = linkage.pivot_d;
  const Vec2d raw = d - a;
  const double largest =
      std::max({linkage.crank, linkage.coupler, linkage.rocker, std::abs(raw.x), std::abs(raw.y)});
  const double scale = 1 / std::ldexp(1.0, std::ilogb(largest));
  const Vec2d frame = scale * raw;
  const Vec2d frame_low =
      scale * Vec2d{difference_error(d.x, a.x, raw.x), difference_error(d.y, a.y, raw.y)};
  const LongLength<double> length = long_length(frame, frame_low);

  lengths_ = {scale * linkage.crank, scale * linkage.coupler, scale * linkage.rocker, length.high};
  frame_low_ = length.low;
  direction_ = (1 / length.high) * frame;
  // e^{iβ/2} is along (r + x, y), and along (|y|, ±(r − x)), which does not cancel for x < 0.
  const TwoParts<double> along =
      two_part_sum(length.high, std::abs(frame.x),
                   length.low + std::copysign(frame_low.x, frame_low.x * frame.x));
  const TwoParts<double> across{frame.y, frame_low.y};
  half_frame_ = {along, across};
  if (frame.x < 0) half_frame_ = frame.y < 0 ? Vec2{-across, -along} : Vec2{across, along};
  inverse_half_ = 1 / std::sqrt(2 * length.high * along.high);
}

Vec2d FrameAxes::half_crank(double crank_angle) const {
  const TwoParts<double> cosine{std::cos(0.5 * crank_angle), 0};
  const TwoParts<double> sine{std::sin(0.5 * crank_angle), 0};
  const auto& [x, y] = half_frame_;
  return inverse_half_ * Vec2d{rounded_sum(product(cosine, x), product(sine, y)),
                               rounded_sum(product(sine, x), -product(cosine, y))};
}

}  // namespace cognate
