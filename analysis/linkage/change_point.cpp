#include "analysis/linkage/change_point.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate {
namespace {

constexpr double kRounding = 16 * std::numeric_limits<double>::epsilon();

/// a + b − c as an unevaluated sum.
TwoParts<double> long_sum(double a, double b, double c) {
  const TwoParts<double> sum = two_part_sum(a, b);
  return two_part_sum(sum.high, -c, sum.low);
}

/// The frame that makes the equal sums of a `single` change point equal without rounding.
TwoParts<double> matching_frame(const Lengths<double>& links, const EqualSums& equal) {
  const auto& [l1, l2, l3, l4] = links;
  if (equal.first) return long_sum(l1, l2, l3);
  return equal.second ? long_sum(l1, l3, l2) : long_sum(l2, l3, l1);
}

/// The lengths with those equal that `kind` says are.
Lengths<double> equalised(const Lengths<double>& links, ChangePointClass kind) {
  const auto& [l1, l2, l3, l4] = links;
  switch (kind) {
    case ChangePointClass::parallelogram:
      return {l1, l4, l1, l4};
    case ChangePointClass::kite_b_on_d:
      return {l1, l2, l2, l1};
    case ChangePointClass::kite_c_on_a:
      return {l1, l1, l4, l4};
    case ChangePointClass::rhombus:
      return {l1, l1, l1, l1};
    case ChangePointClass::none:
    case ChangePointClass::single:
      break;
  }
  return links;
}

/// The sign of `value`, or where that is zero but for rounding of what it becomes.
double sign_after(double value, double rate) {
  return std::copysign(1.0, std::abs(value) <= kRounding ? rate : value);
}

}  // namespace

struct ChangePointMotion::Roots {
  double p = 0, p_rate = 0;
  double q = 0, q_rate = 0;
};

ChangePointMotion::ChangePointMotion(const FourBar& linkage, ChangePointClass kind)
    : linkage_(linkage), class_(kind), axes_(linkage) {
  const EqualSums equal = equal_sums(axes_.lengths());
  towards_ = equal.first || equal.second;
  away_ = equal.third;
  links_ = equalised(axes_.lengths(), kind);
  double frame_low = 0;
  if (kind == ChangePointClass::single) {
    const TwoParts<double> frame = matching_frame(links_, equal);
    links_.frame = frame.high;
    frame_low = frame.low;
  }
  near_ = HalfClosure<double>(links_, +1, frame_low);
  far_ = HalfClosure<double>(links_, -1, frame_low);
}

std::optional<ChangePointMotion> ChangePointMotion::through(const FourBar& linkage, double start) {
  const ChangePointClass kind = change_point_class(FrameAxes(linkage).lengths());
  if (kind == ChangePointClass::none) return std::nullopt;
  ChangePointMotion motion(linkage, kind);
  const Vec2d half = motion.axes_.half_crank(start);
  motion.sign_ = sign(linkage.assembly);
  if (motion.towards_) motion.sign_ *= sign_after(half.y, half.x);
  if (motion.away_) motion.sign_ *= sign_after(half.x, -half.y);
  return motion;
}

ChangePointMotion::Roots ChangePointMotion::roots(const Vec2d& half,
                                                  const CrankDirection<double>& crank,
                                                  const ClosureTriangle<double>& side) const {
  const double at_line = 2 * std::sqrt(links_.crank * links_.frame);  // √(2k)
  const double slope = links_.crank * links_.frame * crank.sin;       // ½ dp/dθ = −½ dq/dθ
  Roots roots;
  roots.p = towards_ ? at_line * half.y : std::sqrt(side.p);
  roots.p_rate = towards_ ? 0.5 * at_line * half.x : slope / roots.p;
  roots.q = sign_ * (away_ ? at_line * half.x : std::sqrt(side.q));
  roots.q_rate = away_ ? -0.5 * sign_ * at_line * half.y : -slope / roots.q;
  return roots;
}

std::optional<ChangePointPose> ChangePointMotion::at(double crank_angle) const {
  const Vec2d half = axes_.half_crank(crank_angle);
  const CrankDirection<double> crank = crank_direction(half);
  const HalfClosure<double>& closure = crank.side > 0 ? near_ : far_;
  const ClosureTriangle<double> side = closure.triangle(crank.versine);
  const Roots root = roots(half, crank, side);
  if (meets_d()) return about_d(crank_angle, half, root);

  const double h = root.p * root.q, h_rate = root.p_rate * root.q + root.p * root.q_rate;
  const Vec2d diagonal{closure.alpha() + closure.signed_crank() * crank.versine,
                       -closure.crank() * crank.sin};
  const ClosureRatios<double> ratio = closure.ratios(side, 1 / side.d2, 0.5 * h);
  const LinkDirections<double> links{(1 / links_.coupler) * (ratio.coupler * diagonal),
                                     (1 / links_.rocker) * (ratio.rocker * diagonal), h * h};
  // The turn of B→D, and of the links against it: arg(m + ih) and arg(n + ih).
  const double slope = 2 * links_.crank * links_.frame * crank.sin;
  const double turn = links_.crank * (links_.crank - links_.frame * crank.cos) / side.d2;
  const auto against = [&](double half_part, double part_rate, double length) {
    return (2 * half_part * h_rate - h * part_rate) / (4 * side.d2 * length * length);
  };
  ChangePointPose at{pose(linkage_, axes_.direction(), crank_angle, links),
                     turn + against(side.half_m, slope, links_.coupler),
                     turn + against(side.half_n, -slope, links_.rocker), true};
  if (!std::isfinite(at.coupler_rate + at.rocker_rate + links.coupler.x)) return std::nullopt;
  return at;
}

/// With crank = frame and coupler = rocker d = |root_p|, which divides out:
/// C − B = (root_p + i root_q)/2 · (−i e^{iθ/2}), C − D = (−root_p + i root_q)/2 · (−i e^{iθ/2}).
std::optional<ChangePointPose> ChangePointMotion::about_d(double crank_angle, const Vec2d& half,
                                                          const Roots& root) const {
  const Vec2d along = -perp(half);
  const double scale = 0.5 / links_.coupler;
  const LinkDirections<double> links{scale * (Vec2d{root.p, root.q} * along),
                                     scale * (Vec2d{-root.p, root.q} * along), 0};
  // d(root_p)/dθ over root_q; both vanish together in a rhombus.
  const double rate = class_ == ChangePointClass::rhombus ? 0.5 * sign_ : root.p_rate / root.q;
  if (!std::isfinite(rate) || !std::isfinite(links.coupler.x)) return std::nullopt;
  return ChangePointPose{pose(linkage_, axes_.direction(), crank_angle, links), 0.5 - rate,
                         0.5 + rate, std::abs(half.y) > kRounding};
}

ChangePointPath ChangePointMotion::path() const {
  switch (class_) {
    case ChangePointClass::parallelogram:
      return sign_ > 0 ? ChangePointPath::parallelogram : ChangePointPath::antiparallelogram;
    case ChangePointClass::rhombus:
      return sign_ > 0 ? ChangePointPath::parallelogram : ChangePointPath::folded;
    case ChangePointClass::kite_c_on_a:
      return sign_ > 0 ? ChangePointPath::deltoid : ChangePointPath::folded;
    case ChangePointClass::kite_b_on_d:
      return ChangePointPath::deltoid;
    case ChangePointClass::none:
    case ChangePointClass::single:
      break;
  }
  return ChangePointPath::single;
}

std::string_view change_point_kind(const FourBar& linkage, double start) {
  const auto motion = ChangePointMotion::through(linkage, start);
  if (!motion) return "";
  switch (motion->kind()) {
    case ChangePointClass::parallelogram:
      return motion->path() == ChangePointPath::parallelogram ? "parallelogram"
                                                              : "antiparallelogram";
    case ChangePointClass::kite_b_on_d:
    case ChangePointClass::kite_c_on_a:
      return "kite";
    case ChangePointClass::rhombus:
      return "rhombus";
    case ChangePointClass::none:
    case ChangePointClass::single:
      break;
  }
  return "single";
}

bool ChangePointMotion::meets_d() const {
  return class_ == ChangePointClass::kite_b_on_d || class_ == ChangePointClass::rhombus;
}

double ChangePointMotion::period() const {
  return towards_ && away_ ? kTurn : 2 * kTurn;
}

std::vector<ChangeAngle> ChangePointMotion::change_angles() const {
  const double frame = std::atan2(axes_.direction().y, axes_.direction().x);
  std::vector<ChangeAngle> angles;
  if (towards_) angles.push_back({in_one_turn(frame), !meets_d()});
  if (away_) angles.push_back({in_one_turn(frame + kPi), true});
  return angles;
}

}  // namespace cognate
