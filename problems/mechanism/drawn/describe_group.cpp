#include "problems/mechanism/drawn/describe_group.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/mechanism/group_equations.hpp"
#include "analysis/numbers/angle.hpp"

namespace cognate::problems::reading {
namespace {

Placement axes_of(const Drawing& drawing, std::size_t link) {
  const double size = size_of(drawing);
  Placement axes;
  bool has_pin = false;
  for (const std::size_t i : joints_of(drawing, link)) {
    const DrawnJoint& joint = drawing.joints[i];
    if (joint.direction) {
      axes.direction = *joint.direction;
    } else if (!has_pin) {
      axes.origin = joint.at;
      has_pin = true;
    }
  }
  for (const std::size_t i : joints_of(drawing, link)) {
    const DrawnJoint& joint = drawing.joints[i];
    const Vec2d along = joint.at - axes.origin;
    if (joint.direction || norm(along) <= kDrawnRounding * size) continue;
    axes.direction = (1 / norm(along)) * along;
    break;
  }
  return axes;
}

class GroupDescriber {
 public:
  GroupDescriber(const Drawing& drawing, const DrawnGroup& group, const DescribedLinks& links)
      : drawing_(drawing), group_(group), links_(links), size_(size_of(drawing)) {}

  /// Adds what the drawing's joint `i` is of the group: of a pin of m links m − 1 joints. Whether
  /// it is one of the group.
  bool add_joints(std::size_t i, std::vector<GroupJointDescription>& joints) const {
    const DrawnJoint& drawn = drawing_.joints[i];
    std::vector<std::size_t> of = drawn.of;
    std::erase_if(of, [&](std::size_t link) { return !is_described(link); });
    if (of.size() < 2 || std::ranges::none_of(of, [&](std::size_t k) { return is_own(k); })) {
      return false;
    }
    // A link that is there before carries the pin or the guide, else one with the most joints.
    std::ranges::stable_sort(of, {}, [&](std::size_t link) {
      const auto count = static_cast<std::ptrdiff_t>(joints_of(drawing_, link).size());
      return std::pair(is_own(link), drawn.direction ? -count : 0);
    });
    for (std::size_t k = 1; k < of.size(); ++k) {
      if (is_own(of[k])) joints.push_back(described(drawn, of[0], of[k]));
    }
    return true;
  }

 private:
  bool is_own(std::size_t link) const {
    return std::ranges::find(group_.links, link) != group_.links.end();
  }
  bool is_described(std::size_t link) const {
    return std::ranges::find(links_.numbers, link) != links_.numbers.end();
  }

  GroupJointDescription described(const DrawnJoint& drawn, std::size_t first,
                                  std::size_t second) const {
    const Vec2d place = drawn.direction ? links_.axes[second].origin : drawn.at;
    GroupJointDescription joint{
        .name = drawn.name,
        .of = {drawing_.links[first], drawing_.links[second]},
        .at = {links_.in_axes(first, place, size_), links_.in_axes(second, place, size_)},
        .directions = {}};
    if (!drawn.direction) return joint;
    joint.name.clear();
    const auto angle = [&](std::size_t link) {
      return angle_of(conj(links_.axes[link].direction) * *drawn.direction);
    };
    joint.directions = {angle(first), angle(second)};
    return joint;
  }

  const Drawing& drawing_;
  const DrawnGroup& group_;
  const DescribedLinks& links_;
  double size_;
};

}  // namespace

double size_of(const Drawing& drawing) {
  double size = 0;
  for (const DrawnJoint& joint : drawing.joints) size = std::max(size, norm1(joint.at));
  return size;
}

Vec2d DescribedLinks::in_axes(std::size_t link, const Vec2d& place, double size) const {
  const Vec2d at = conj(axes[link].direction) * (place - axes[link].origin);
  const auto rounded = [&](double x) { return std::abs(x) <= kDrawnRounding * size ? 0 : x; };
  return {rounded(at.x), rounded(at.y)};
}

DescribedGroup describe_group(const Drawing& drawing, const DrawnGroup& group, double drive,
                              DescribedLinks& links) {
  DescribedGroup described;
  described.group.drive = drive;
  for (const std::size_t link : group.links) {
    links.axes[link] = axes_of(drawing, link);
    links.numbers.push_back(link);
    described.group.names.push_back(drawing.links[link]);
    described.group.drawn.push_back(links.axes[link]);
  }
  const GroupDescriber describer(drawing, group, links);
  for (std::size_t i = 0; i < drawing.joints.size(); ++i) {
    if (describer.add_joints(i, described.group.joints)) described.joints.push_back(i);
  }
  return described;
}

bool could_move_alone(const Drawing& drawing, const GroupDescription& group,
                      const DescribedLinks& links) {
  std::vector<BodyMotion<double, 0>> bodies(links.numbers.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    bodies[i].origin[0] = links.axes[links.numbers[i]].origin;
    bodies[i].direction = links.axes[links.numbers[i]].direction;
  }
  const auto number = [&](const std::string& link) {
    const auto named = [&](std::size_t i) { return drawing.links[i] == link; };
    return static_cast<int>(std::ranges::find_if(links.numbers, named) - links.numbers.begin());
  };
  Group equivalent{.drawn = group.drawn, .joints = {}};
  for (const GroupJointDescription& joint : group.joints) {
    GroupJoint added{{number(joint.of[0]), joint.at[0]}, {number(joint.of[1]), joint.at[1]}};
    if (joint.directions) {
      added.slides = true;
      added.along_first = unit_vector((*joint.directions)[0]);
      added.along_second = unit_vector((*joint.directions)[1]);
    }
    equivalent.joints.push_back(added);
  }
  const GroupEquations equations(equivalent, bodies.size() - group.drawn.size());
  return !(std::abs(group_sine(equations.matrix<0>(bodies))) > kDeadGroupSine);
}

}  // namespace cognate::problems::reading
