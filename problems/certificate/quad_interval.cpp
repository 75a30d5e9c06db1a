#include "problems/certificate/quad_interval.hpp"

#include <boost/math/constants/constants.hpp>

namespace cognate::problems {
namespace {

/// More than a sine, a cosine or an angle of a few turns is off by.
const Quad& trigonometric_margin() {
  static const Quad margin = ldexp(Quad(1), -100);
  return margin;
}

QuadInterval about(const Quad& value) {
  return within({value - trigonometric_margin(), value + trigonometric_margin()}, -1, 1);
}

/// Whether `phase` or an angle whole turns from it lies in `angle`; in doubt it does.
bool passes(const QuadInterval& angle, const Quad& phase) {
  const Quad turns = ceil((angle.low - trigonometric_margin() - phase) / quad_turn());
  return phase + turns * quad_turn() <= angle.high + trigonometric_margin();
}

}  // namespace

const Quad& quad_turn() {
  static const Quad turn = boost::math::constants::two_pi<Quad>();
  return turn;
}

QuadInterval cosine_between(const QuadInterval& angle, const QuadInterval& at_low,
                            const QuadInterval& at_high) {
  QuadInterval range{std::min(at_low.low, at_high.low), std::max(at_low.high, at_high.high)};
  if (passes(angle, 0)) range.high = 1;
  if (passes(angle, quad_turn() / 2)) range.low = -1;
  return range;
}

QuadInterval cosine(const Quad& angle) {
  return about(cos(angle));
}

QuadInterval sine(const Quad& angle) {
  return about(sin(angle));
}

QuadInterval cosine(const QuadInterval& angle) {
  return cosine_between(angle, cosine(angle.low), cosine(angle.high));
}

QuadInterval sine(const QuadInterval& angle) {
  const Quad quarter = quad_turn() / 4;
  return cosine_between({angle.low - quarter, angle.high - quarter}, sine(angle.low),
                        sine(angle.high));
}

}  // namespace cognate::problems
