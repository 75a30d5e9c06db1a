#include "problems/mechanism/drawn/describe_drawing.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "analysis/numbers/angle.hpp"
#include "problems/mechanism/drawn/describe_group.hpp"
#include "problems/mechanism/part_names.hpp"
#include "problems/toml/nearest.hpp"

namespace cognate::problems::reading {
namespace {

/// Sines of angles below this are those of a dead point: there the drawing does not say which of
/// two assemblies is meant. The end of the motion is some squares of it away, 1e-12, and an angle
/// is known to 1e-15.
constexpr double kDeadSine = 1e-6;

/// Whether a joint of the driving link can be its pin: any of a slider, of a crank one that is not
/// at its pivot.
bool is_away(const DrawnJoint& joint, const DrawnJoint& on_frame, double size) {
  if (&joint == &on_frame || joint.direction) return false;
  return on_frame.direction || norm(joint.at - on_frame.at) > kDrawnRounding * size;
}

class Describer {
 public:
  Describer(const Drawing& drawing, FaultList& faults)
      : drawing_(drawing),
        faults_(faults),
        links_{std::vector<Placement>(drawing.links.size()), {0, drawing.driven}},
        size_(size_of(drawing)) {}

  void describe_frame() {
    for (const std::size_t i : pins_of(0)) {
      described_.chain.pivots.push_back({joint(i).name, joint(i).at});
    }
  }

  void describe_drive() {
    const std::size_t link = drawing_.driven;
    std::size_t on_frame = 0;
    for (const std::size_t i : joints_of(drawing_, link)) {
      if (joins(joint(i), 0)) on_frame = i;
    }
    const std::size_t pin = driving_pin(link, on_frame);
    if (joint(on_frame).direction) {
      links_.axes[link] = {joint(pin).at, *joint(on_frame).direction};
      described_.chain.drive =
          SliderDescription{slide_of(on_frame, 0, joint(pin).at), joint(pin).name, name(link)};
    } else {
      const double length = length_of(link, on_frame, pin);
      if (length == 0) return;
      const Vec2d along = joint(pin).at - joint(on_frame).at;
      links_.axes[link] = {joint(on_frame).at, (1 / length) * along};
      described_.drive = angle_of(along);
      described_.chain.drive =
          CrankDescription{joint(on_frame).name, joint(pin).name, length, name(link)};
    }
    add_points(link, {on_frame, pin});
  }

  void describe(const DrawnDyad& found) {
    DrawnDyad dyad = found;
    const auto swap = [&] {
      std::swap(dyad.first, dyad.second);
      std::swap(dyad.first_outer, dyad.second_outer);
    };
    const bool slides = joint(dyad.inner).direction.has_value();
    const bool first = joint(dyad.first_outer).direction.has_value();
    const bool second = joint(dyad.second_outer).direction.has_value();
    if (first && second && slides) return fault_slides(dyad);
    if (first && !second) swap();
    if (is_rigid(dyad)) return;
    if (first && second) return describe_prp(dyad);
    if (first || second) return slides ? describe_rpp(dyad) : describe_rrp(dyad);
    if (!slides) return describe_rrr(dyad);
    // The bar is the link that others are joined to.
    if (joints_of(drawing_, dyad.first).size() > joints_of(drawing_, dyad.second).size()) swap();
    describe_rpr(dyad);
  }

  void describe(const DrawnGroup& group) {
    auto [described, joints] = describe_group(drawing_, group, described_.drive, links_);
    if (could_move_alone(drawing_, described, links_)) fault_dead(group);
    described_.chain.dyads.push_back(
        {.type = DyadType::group, .names = {}, .group = std::move(described)});
    for (const std::size_t link : group.links) add_points(link, joints);
  }

  DescribedDrawing take() { return std::move(described_); }

 private:
  const DrawnJoint& joint(std::size_t i) const { return drawing_.joints[i]; }
  const std::string& name(std::size_t link) const { return drawing_.links[link]; }

  std::vector<std::size_t> pins_of(std::size_t link) const {
    auto pins = joints_of(drawing_, link);
    std::erase_if(pins, [&](std::size_t i) { return joint(i).direction.has_value(); });
    return pins;
  }

  /// A joint of the driving link other than the drive's own: a pin rather than a point, and best
  /// away from it.
  std::size_t driving_pin(std::size_t link, std::size_t on_frame) const {
    auto pins = pins_of(link);
    std::erase(pins, on_frame);
    const auto worth = [&](std::size_t i) {
      return std::pair(is_away(joint(i), joint(on_frame), size_), joint(i).of.size() > 1);
    };
    return *std::ranges::max_element(pins, {}, worth);
  }

  /// From one joint of a link to another; 0, with a fault, where they coincide.
  double length_of(std::size_t link, std::size_t from, std::size_t to) {
    const double length = norm(joint(to).at - joint(from).at);
    if (length > kDrawnRounding * size_) return length;
    faults_.add(joint(to).where,
                fmt::format("joints {} of {} are at the same place; expected a distance",
                            joint_names(drawing_, {from, to}), in_quotes(name(link))));
    return 0;
  }

  void fault_slides(const DrawnDyad& dyad) {
    faults_.add(
        joint(dyad.inner).where,
        fmt::format("joints {} of {} and {} are slides, all three; expected a pin among "
                    "them, without which no link turns",
                    joint_names(drawing_, {dyad.first_outer, dyad.inner, dyad.second_outer}),
                    in_quotes(name(dyad.first)), in_quotes(name(dyad.second))));
  }

  /// Whether both outer joints are on one link, so that nothing moves on it; then a fault.
  bool is_rigid(const DrawnDyad& dyad) {
    const auto link = shared_link(drawing_, dyad);
    if (!link) return false;
    faults_.add(joint(dyad.inner).where,
                fmt::format("joint {} of {} and {}, which are both joined to {}, cannot move on it "
                            "(mobility 0); expected one link in the place of the three",
                            in_quotes(joint(dyad.inner).name), in_quotes(name(dyad.first)),
                            in_quotes(name(dyad.second)), in_quotes(name(*link))));
    return true;
  }

  /// Whether `sine` is that of a dead point; then a fault.
  bool is_dead(const DrawnDyad& dyad, double sine) {
    if (std::abs(sine) > kDeadSine) return false;
    faults_.add(
        joint(dyad.inner).where,
        fmt::format("joints {} of {} and {} are drawn at a dead point, where two assemblies meet; "
                    "expected another position",
                    joint_names(drawing_, {dyad.first_outer, dyad.inner, dyad.second_outer}),
                    in_quotes(name(dyad.first)), in_quotes(name(dyad.second))));
    return true;
  }

  void fault_dead(const DrawnGroup& group) {
    std::vector<std::string_view> names;
    for (const std::size_t link : group.links) names.push_back(name(link));
    faults_.add(joint(joints_of(drawing_, group.links.front()).front()).where,
                fmt::format("{} are drawn at a dead point, where two assemblies meet, or a part of "
                            "them cannot move while another is loose; expected another position",
                            listed(std::move(names))));
  }

  static Assembly assembly_of(double signed_sine) {
    return signed_sine > 0 ? Assembly::open : Assembly::crossed;
  }

  /// The link that carries the outer slide of `link`.
  std::size_t carrier(std::size_t slide, std::size_t link) const {
    return joint(slide).of[joint(slide).of[0] == link ? 1 : 0];
  }

  Vec2d in_axes(std::size_t link, const Vec2d& place) const {
    return links_.in_axes(link, place, size_);
  }

  /// The line of a slide on `link` through a place of the drawing.
  SlideDescription slide_of(std::size_t slide, std::size_t link, const Vec2d& through) const {
    return {in_axes(link, through),
            angle_of(conj(links_.axes[link].direction) * *joint(slide).direction), 0, name(link)};
  }

  void describe_rrr(const DrawnDyad& dyad) {
    const Vec2d c = joint(dyad.inner).at;
    const double first = length_of(dyad.first, dyad.first_outer, dyad.inner);
    const double second = length_of(dyad.second, dyad.second_outer, dyad.inner);
    if (first == 0 || second == 0) return;
    const Vec2d p = (1 / first) * (c - joint(dyad.first_outer).at);
    const Vec2d q = (1 / second) * (c - joint(dyad.second_outer).at);
    const double sine = cross(p, q);
    if (is_dead(dyad, sine)) return;
    DyadDescription described{
        .type = DyadType::rrr,
        .joins = {joint(dyad.first_outer).name, joint(dyad.second_outer).name},
        .lengths = {first, second},
        .assembly = assembly_of(sine),
        .new_point = joint(dyad.inner).name};
    links_.axes[dyad.first] = {joint(dyad.first_outer).at, p};
    links_.axes[dyad.second] = {joint(dyad.second_outer).at, q};
    add(std::move(described), dyad);
  }

  void describe_rrp(const DrawnDyad& dyad) {
    const Vec2d pin = joint(dyad.inner).at;
    const Vec2d guide = *joint(dyad.second_outer).direction;
    const double length = length_of(dyad.first, dyad.first_outer, dyad.inner);
    if (length == 0) return;
    const Vec2d along = (1 / length) * (pin - joint(dyad.first_outer).at);
    const double sine = dot(along, guide);
    if (is_dead(dyad, sine)) return;
    DyadDescription described{
        .type = DyadType::rrp,
        .joins = {joint(dyad.first_outer).name},
        .lengths = {length},
        .slides = {slide_of(dyad.second_outer, carrier(dyad.second_outer, dyad.second), pin)},
        .assembly = assembly_of(sine),
        .new_point = joint(dyad.inner).name};
    links_.axes[dyad.first] = {joint(dyad.first_outer).at, along};
    links_.axes[dyad.second] = {pin, guide};
    add(std::move(described), dyad);
  }

  /// The bar points to the block, so that the assembly is open.
  void describe_rpr(const DrawnDyad& dyad) {
    const Vec2d block = joint(dyad.first_outer).at;
    const Vec2d pivot = joint(dyad.second_outer).at;
    const double distance = norm(block - pivot);
    const Vec2d line = *joint(dyad.inner).direction;
    const double along = dot(block - pivot, line);
    if (is_dead(dyad, distance > kDrawnRounding * size_ ? along / distance : 0)) return;
    const Vec2d bar = along > 0 ? line : -line;
    const double offset = cross(bar, block - pivot);
    DyadDescription described{
        .type = DyadType::rpr,
        .joins = {joint(dyad.first_outer).name, joint(dyad.second_outer).name},
        .offset = std::abs(offset) <= kDrawnRounding * size_ ? 0 : offset,
        .assembly = Assembly::open};
    links_.axes[dyad.first] = {block, bar};
    links_.axes[dyad.second] = {pivot, bar};
    add(std::move(described), dyad);
  }

  void describe_prp(const DrawnDyad& dyad) {
    const Vec2d pin = joint(dyad.inner).at;
    const Vec2d first = *joint(dyad.first_outer).direction;
    const Vec2d second = *joint(dyad.second_outer).direction;
    if (is_dead(dyad, cross(first, second))) return;
    DyadDescription described{
        .type = DyadType::prp,
        .slides = {slide_of(dyad.first_outer, carrier(dyad.first_outer, dyad.first), pin),
                   slide_of(dyad.second_outer, carrier(dyad.second_outer, dyad.second), pin)},
        .new_point = joint(dyad.inner).name};
    links_.axes[dyad.first] = {pin, first};
    links_.axes[dyad.second] = {pin, second};
    add(std::move(described), dyad);
  }

  /// Slot and guide cross where the block's pin is drawn: that point of the slider has its name.
  void describe_rpp(const DrawnDyad& dyad) {
    const Vec2d pin = joint(dyad.first_outer).at;
    const Vec2d slot = *joint(dyad.inner).direction;
    const Vec2d guide = *joint(dyad.second_outer).direction;
    if (is_dead(dyad, cross(guide, slot))) return;
    DyadDescription described{
        .type = DyadType::rpp,
        .joins = {joint(dyad.first_outer).name},
        .slides = {slide_of(dyad.second_outer, carrier(dyad.second_outer, dyad.second), pin)},
        .slot = angle_of(conj(guide) * slot),
        .new_point = name(dyad.second)};
    links_.axes[dyad.first] = {pin, slot};
    links_.axes[dyad.second] = {pin, guide};
    add(std::move(described), dyad);
  }

  void add(DyadDescription described, const DrawnDyad& dyad) {
    described.names = {name(dyad.first), name(dyad.second)};
    links_.numbers.insert(links_.numbers.end(), {dyad.first, dyad.second});
    described_.chain.dyads.push_back(std::move(described));
    add_points(dyad.first, {dyad.first_outer, dyad.inner});
    add_points(dyad.second, {dyad.second_outer, dyad.inner});
  }

  /// The joints of a link other than `known`, which its dyad or the drive has.
  void add_points(std::size_t link, const std::vector<std::size_t>& known) {
    for (const std::size_t i : pins_of(link)) {
      if (std::ranges::find(known, i) != known.end()) continue;
      described_.points.push_back({joint(i).name, {name(link)}, in_axes(link, joint(i).at)});
    }
  }

  const Drawing& drawing_;
  FaultList& faults_;
  DescribedLinks links_;
  DescribedDrawing described_;
  double size_;
};

std::string free_name(const Drawing& drawing, std::string name) {
  const auto is_taken = [&] {
    return std::ranges::find(drawing.links, name) != drawing.links.end() ||
           std::ranges::find(drawing.joints, name, &DrawnJoint::name) != drawing.joints.end();
  };
  while (is_taken()) name += "'";
  return name;
}

/// A driving link with no pin but that of the frame, such as a lever on which a block slides, has
/// a point of its own beside it.
Drawing with_driving_pin(Drawing drawing) {
  const std::size_t link = drawing.driven;
  const auto of_link = joints_of(drawing, link);
  const auto joint = [&](std::size_t i) -> const DrawnJoint& { return drawing.joints[i]; };
  const auto on_frame =
      std::ranges::find_if(of_link, [&](std::size_t i) { return joins(joint(i), 0); });
  const double size = size_of(drawing);
  Vec2d along{1, 0};
  for (const std::size_t i : of_link) {
    if (i != *on_frame && !joint(i).direction) return drawing;
    if (joint(i).direction) along = *joint(i).direction;
  }
  DrawnJoint end{.name = free_name(drawing, drawing.links[link] + "-end"),
                 .of = {link},
                 .where = joint(*on_frame).where};
  end.at = joint(*on_frame).at + (size > 0 ? size : 1) * along;
  drawing.joints.push_back(std::move(end));
  return drawing;
}

}  // namespace

std::optional<DescribedDrawing> describe(const Drawing& given, const DrawnGroups& groups,
                                         FaultList& faults) {
  const std::size_t before = faults.size();
  const Drawing drawing = with_driving_pin(given);
  Describer describer(drawing, faults);
  describer.describe_frame();
  describer.describe_drive();
  for (const auto& group : groups.groups) {
    if (faults.size() != before) return std::nullopt;
    std::visit([&](const auto& links) { describer.describe(links); }, group);
  }
  if (faults.size() != before) return std::nullopt;
  return describer.take();
}

}  // namespace cognate::problems::reading
