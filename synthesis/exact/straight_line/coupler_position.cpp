#include "synthesis/exact/straight_line/coupler_position.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "analysis/linkage/change_point.hpp"
#include "analysis/linkage/four_bar.hpp"
#include "analysis/linkage/motion.hpp"
#include "analysis/linkage/slider_crank_mobility.hpp"
#include "analysis/mechanism/kinematics.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::synthesis {
namespace {

std::optional<CouplerPosition> position(const FourBar& linkage, double crank_angle) {
  const double from_frame = crank_angle - frame_angle(linkage);
  const LinkDirections<double> at = Motion(linkage).directions(from_frame);
  if (!(at.discriminant >= 0)) return std::nullopt;
  const Lengths<double> links = lengths(linkage);
  const Vec2d crank = unit_vector(crank_angle);
  // From the frame's axes; the crank's direction has the rounding of both angles.
  const Vec2d frame = (1 / links.frame) * (linkage.pivot_d - linkage.pivot_a);
  const double size = std::max({links.crank, links.coupler, links.rocker, links.frame});
  return CouplerPosition{
      four_bar_series<kContactOrder, double>(links, crank, frame * at.coupler, frame * at.rocker),
      size, std::nullopt};
}

std::optional<CouplerPosition> position(const SliderCrank& linkage, double crank_angle) {
  MechanismMotion<0> motion(as_mechanism(linkage));
  if (!motion.move_to(crank_angle)) return std::nullopt;
  const Vec2d crank = unit_vector(crank_angle);
  const double size = std::max({linkage.crank, linkage.coupler, std::abs(linkage.offset)});
  const Vec2d coupler = motion.bodies()[2].direction;
  return CouplerPosition{slider_crank_series<kContactOrder, double>(
                             linkage.crank, linkage.coupler, crank, coupler, linkage.direction),
                         size, linkage.coupler * coupler};
}

/// Angles from the x axis.
std::vector<CrankRange> closing_ranges(const FourBar& linkage) {
  std::vector<CrankRange> ranges = crank_ranges(lengths(linkage));
  for (CrankRange& range : ranges) {
    range.from += frame_angle(linkage);
    range.to += frame_angle(linkage);
  }
  return ranges;
}

double slide_angle(const SliderCrank& linkage) {
  return std::atan2(linkage.direction.y, linkage.direction.x);
}

std::vector<CrankRange> closing_ranges(const SliderCrank& linkage) {
  std::vector<CrankRange> ranges = crank_ranges(linkage);
  const double slide = slide_angle(linkage);
  for (CrankRange& range : ranges) {
    range.from += slide;
    range.to += slide;
  }
  return ranges;
}

std::vector<double> change_angles(const FourBar& linkage) {
  std::vector<double> angles;
  const auto motion = ChangePointMotion::through(linkage, frame_angle(linkage));
  if (!motion) return angles;
  for (const ChangeAngle& angle : motion->change_angles()) angles.push_back(angle.crank_angle);
  return angles;
}

std::vector<double> change_angles(const SliderCrank& linkage) {
  std::vector<double> angles;
  for (const SliderPosition& position : change_points(linkage)) {
    angles.push_back(slide_angle(linkage) + position.crank_angle);
  }
  return angles;
}

/// `angle` moved by whole turns to just below `place`, or to it.
double turned_below(double angle, double place) {
  return angle + kTurn * std::floor((place - angle) / kTurn);
}

/// What is left of a range between the angles, without `margin` on either side of them.
std::vector<CrankRange> parts(const CrankRange& range, const std::vector<double>& angles,
                              double margin) {
  std::vector<double> cuts;
  for (const double angle : angles) {
    double cut = turned_below(angle, range.to + margin);
    for (; cut >= range.from - margin; cut -= kTurn) cuts.push_back(cut);
  }
  std::ranges::sort(cuts);
  std::vector<CrankRange> found;
  double from = range.from;
  for (const double cut : cuts) {
    if (cut - margin > from) found.push_back({from, cut - margin});
    from = cut + margin;
  }
  if (range.to > from) found.push_back({from, range.to});
  return found;
}

}  // namespace

std::optional<CouplerPosition> coupler_position(const CouplerLinkage& linkage, double crank_angle) {
  return std::visit([&](const auto& any) { return position(any, crank_angle); }, linkage);
}

std::vector<CrankRange> crank_ranges(const CouplerLinkage& linkage, double margin) {
  return std::visit(
      [margin](const auto& any) {
        const std::vector<double> angles = change_angles(any);
        std::vector<CrankRange> found;
        for (const CrankRange& range : closing_ranges(any)) {
          std::ranges::move(parts(range, angles, margin), std::back_inserter(found));
        }
        return found;
      },
      linkage);
}

std::optional<CrankRange> range_about(const CouplerLinkage& linkage, double crank_angle) {
  // Positions at the ends of ranges are known to rounding.
  constexpr double kSlack = 1e-9;
  const auto closing = std::visit([](const auto& any) { return closing_ranges(any); }, linkage);
  const auto angles = std::visit([](const auto& any) { return change_angles(any); }, linkage);
  for (const CrankRange& range : closing) {
    const double turns = kTurn * std::floor((crank_angle - range.from + kSlack) / kTurn);
    if (crank_angle - turns > range.to + kSlack) continue;
    CrankRange about{range.from + turns, range.to + turns};
    if (range.to - range.from >= kTurn) about = {crank_angle - kTurn, crank_angle + kTurn};
    for (const double angle : angles) {
      const double below = turned_below(angle, crank_angle);
      about.from = std::max(about.from, below);
      about.to = std::min(about.to, below + kTurn);
    }
    return about;
  }
  return std::nullopt;
}

}  // namespace cognate::synthesis
