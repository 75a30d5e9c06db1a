#include "synthesis/exact/motion/guided_mechanism.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/linkage/four_bar.hpp"
#include "analysis/numbers/angle.hpp"

namespace cognate::synthesis {
namespace {

using Poses = std::span<const Pose>;

/// Lengths and sines below this, relative to the linkage, are none.
constexpr double kNothing = 1e-12;

Vec2d normalised(const Vec2d& v) {
  return (1 / norm(v)) * v;
}

Assembly side_of(double signed_area) {
  return signed_area < 0 ? Assembly::crossed : Assembly::open;
}

Vec2d in_frame(const Pose& pose, const Vec2d& body_direction) {
  return unit_vector(pose.angle) * body_direction;
}

/// The body's own axes in axes of origin `at` and first axis `axis` (body axes).
Pose seen_from(const Vec2d& at, const Vec2d& axis) {
  return {conj(axis) * -at, -angle_of(axis)};
}

GuidedMechanism fault(PairingFault fault) {
  return {fault, {}, {}, 0, {}, {}};
}

template <class Type>
GuidedMechanism made(const Type& type, Mechanism<double> chain, int body, const Pose& body_in_link,
                     std::vector<DriveStation> stations) {
  return {PairingFault::none, type, std::move(chain), body, body_in_link, std::move(stations)};
}

template <class Station>
std::vector<DriveStation> at_each(Poses poses, Station station) {
  std::vector<DriveStation> stations;
  stations.reserve(poses.size());
  for (const Pose& pose : poses) stations.push_back(station(pose));
  return stations;
}

bool is_point(const Vec2d& distance, double size) {
  return !(norm(distance) > kNothing * size);
}

/// What lengths of the linkage are compared with.
double size_of(const GuidingDyad& first, const GuidingDyad& second) {
  return std::max({first.length, second.length, norm(first.in_body - second.in_body),
                   norm(first.fixed - second.fixed)});
}

GuidedMechanism four_bar(const GuidingDyad& first, const GuidingDyad& second, Poses poses) {
  const Vec2d coupler = second.in_body - first.in_body;
  const Vec2d axis = normalised(coupler);
  const Pose body = seen_from(first.in_body, axis);
  const auto stations = at_each(poses, [&](const Pose& pose) {
    const Vec2d b = to_frame(pose, first.in_body);
    return DriveStation{angle_of(b - first.fixed),
                        side_of(cross(second.fixed - b, in_frame(pose, coupler)))};
  });
  const FourBar linkage{first.fixed,   second.fixed,     first.length, norm(coupler),
                        second.length, stations[0].side, body.at};
  return made(linkage, as_mechanism(linkage), 2, body, stations);
}

GuidedMechanism slider_crank(const GuidingDyad& link, const GuidingDyad& slider, Poses poses) {
  const Vec2d coupler = slider.in_body - link.in_body;
  const auto stations = at_each(poses, [&](const Pose& pose) {
    return DriveStation{angle_of(to_frame(pose, link.in_body) - link.fixed),
                        side_of(dot(slider.direction, in_frame(pose, coupler)))};
  });
  const SliderCrank linkage{link.fixed,       link.length,
                            norm(coupler),    cross(slider.direction, slider.fixed - link.fixed),
                            slider.direction, stations[0].side};
  return made(linkage, as_mechanism(linkage), 2, seen_from(link.in_body, normalised(coupler)),
              stations);
}

/// The signed distance, to the left of the block's line through `pin`, of the line that the block
/// slides on, and where along it the block stands.
double offset_of(const GuidingDyad& block, const Vec2d& pin) {
  return cross(block.direction, block.in_body - pin);
}

Assembly block_side(const GuidingDyad& block, const Vec2d& pin, const Pose& pose) {
  return side_of(dot(in_frame(pose, block.direction), block.fixed - to_frame(pose, pin)));
}

GuidedMechanism oscillating_block(const GuidingDyad& link, const GuidingDyad& block, Poses poses) {
  const auto stations = at_each(poses, [&](const Pose& pose) {
    return DriveStation{angle_of(to_frame(pose, link.in_body) - link.fixed),
                        block_side(block, link.in_body, pose)};
  });
  const OscillatingBlock linkage{link.fixed, block.fixed, link.length,
                                 offset_of(block, link.in_body), stations[0].side};
  return made(linkage, as_mechanism(linkage), 3, seen_from(link.in_body, block.direction),
              stations);
}

/// The point where the lines p + t·u and q + t·v meet.
Vec2d crossing(const Vec2d& p, const Vec2d& u, const Vec2d& q, const Vec2d& v) {
  return p + (cross(q - p, v) / cross(u, v)) * u;
}

GuidedMechanism trammel(const GuidingDyad& first, const GuidingDyad& second, Poses poses) {
  const Vec2d link = second.in_body - first.in_body;
  const EllipticTrammel linkage{
      crossing(first.fixed, first.direction, second.fixed, second.direction), norm(link),
      first.direction, second.direction * conj(first.direction)};
  return made(linkage, as_mechanism(linkage), 1, seen_from(first.in_body, normalised(link)),
              at_each(poses, [&](const Pose& pose) {
                return DriveStation{angle_of(in_frame(pose, link)), Assembly::open};
              }));
}

GuidedMechanism oldham(const GuidingDyad& first, const GuidingDyad& second, Poses poses) {
  const Vec2d centre = crossing(first.in_body, first.direction, second.in_body, second.direction);
  const OldhamCoupling linkage{first.fixed, second.fixed, second.direction * conj(first.direction)};
  return made(linkage, as_mechanism(linkage), 3, seen_from(centre, first.direction),
              at_each(poses, [&](const Pose& pose) {
                return DriveStation{angle_of(in_frame(pose, first.direction)), Assembly::open};
              }));
}

GuidedMechanism slider_and_block(const GuidingDyad& slider, const GuidingDyad& block, Poses poses) {
  const auto stations = at_each(poses, [&](const Pose& pose) {
    const Vec2d way = displacement(poses[0], pose).way(slider.moving);
    return DriveStation{dot(slider.direction, way), block_side(block, slider.in_body, pose)};
  });
  Mechanism<double> chain;
  chain.drive = DrivingSlider<double>{{0, slider.fixed, slider.direction, 0}};
  chain.dyads.emplace_back(Rpr<double>{.block = {0, block.fixed},
                                       .pivot = {1, {0, 0}},
                                       .offset = offset_of(block, slider.in_body),
                                       .assembly = stations[0].side});
  return made(chain, chain, 3, seen_from(slider.in_body, block.direction), stations);
}

PairingFault find_fault(const GuidingDyad& first, const GuidingDyad& second) {
  const double size = size_of(first, second);
  const auto is_link = [](const GuidingDyad& dyad) { return dyad.kind == DyadKind::rr; };
  for (const GuidingDyad* dyad : {&first, &second}) {
    if (is_link(*dyad) && !(dyad->length > kNothing * size)) return PairingFault::no_link;
  }
  const bool two_slides = !is_link(first) && first.kind == second.kind;
  if (two_slides && std::abs(cross(first.direction, second.direction)) <= kNothing) {
    return PairingFault::parallel_lines;
  }
  const bool points_of_body = first.kind != DyadKind::rp && second.kind != DyadKind::rp;
  if (points_of_body && is_point(first.in_body - second.in_body, size)) {
    return PairingFault::shared_moving_pivot;
  }
  const bool points_of_frame = first.kind != DyadKind::pr && second.kind != DyadKind::pr;
  if (points_of_frame && is_point(first.fixed - second.fixed, size)) {
    return PairingFault::shared_fixed_pivot;
  }
  return PairingFault::none;
}

}  // namespace

std::string_view sentence(PairingFault fault) {
  switch (fault) {
    case PairingFault::none:
      return "the two dyads make a mechanism";
    case PairingFault::shared_moving_pivot:
      return "both dyads hold the body by the same point, so that it may turn about it";
    case PairingFault::shared_fixed_pivot:
      return "both dyads turn about the same fixed pivot, so that they do not guide the body";
    case PairingFault::no_link:
      return "a link has no length: a point of the body stays at its fixed pivot, which is a pin "
             "in the frame";
    case PairingFault::parallel_lines:
      break;
  }
  return "the two dyads slide in one direction, so that the body may slide without turning";
}

GuidedMechanism guided_mechanism(const GuidingDyad& first, const GuidingDyad& second, Poses poses) {
  const PairingFault found = find_fault(first, second);
  if (found != PairingFault::none) return fault(found);
  const bool ordered = static_cast<int>(first.kind) <= static_cast<int>(second.kind);
  const GuidingDyad& a = ordered ? first : second;
  const GuidingDyad& b = ordered ? second : first;
  if (a.kind == DyadKind::rr) {
    if (b.kind == DyadKind::rr) return four_bar(a, b, poses);
    if (b.kind == DyadKind::pr) return slider_crank(a, b, poses);
    return oscillating_block(a, b, poses);
  }
  if (a.kind == DyadKind::rp) return oldham(a, b, poses);
  return b.kind == DyadKind::pr ? trammel(a, b, poses) : slider_and_block(a, b, poses);
}

}  // namespace cognate::synthesis
