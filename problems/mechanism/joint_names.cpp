#include "problems/mechanism/joint_names.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace cognate::problems {
namespace {

/// The same point in the axes of each body it is fixed on.
using Pin = std::vector<Attached<double>>;

bool same_place(const Attached<double>& a, const Attached<double>& b) {
  constexpr double kRounding = 1e-12;
  const Vec2d between = a.at - b.at;
  const double size = std::hypot(a.at.x, a.at.y) + std::hypot(b.at.x, b.at.y);
  return a.body == b.body && std::hypot(between.x, between.y) <= kRounding * size;
}

bool lies_on(const Attached<double>& place, const Pin& pin) {
  return std::ranges::any_of(pin, [&](const auto& other) { return same_place(place, other); });
}

double length_of_first(const Dyad<double>& dyad) {
  if (const auto* rrr = std::get_if<Rrr<double>>(&dyad)) return rrr->first_length;
  if (const auto* rrp = std::get_if<Rrp<double>>(&dyad)) return rrp->length;
  return 0;
}

double length_of_second(const Dyad<double>& dyad) {
  const auto* rrr = std::get_if<Rrr<double>>(&dyad);
  return rrr ? rrr->second_length : 0;
}

/// Where a turning joint of a dyad lies on the two bodies it connects: the outer joints at the
/// origins of the dyad's bodies, the inner one on their first axes.
Pin places_of(const Joint& joint, const Mechanism<double>& mechanism, int group) {
  Pin pin = {joint.at};
  if (group == 0) return pin;
  const auto& dyad = mechanism.dyads[static_cast<std::size_t>(group - 1)];
  const int n = first_body(mechanism, group - 1);
  if (const auto* of_group = std::get_if<Group>(&dyad)) {
    const auto same = [&](const GroupJoint& other) {
      return other.first.body == joint.first && other.second.body == joint.second &&
             !other.slides && other.second.at == joint.at.at;
    };
    return {joint.at, std::ranges::find_if(of_group->joints, same)->first};
  }
  const auto* cylinder = std::get_if<Cylinder<double>>(&dyad);
  if (cylinder && joint.second == n + 1 && joint.first == 1) {
    return {joint.at, {n + 1, {cylinder->length, 0}}};
  }
  if (joint.first == n && joint.second == n + 1) {
    pin.push_back({n, {length_of_first(dyad), 0}});
    pin.push_back({n + 1, {length_of_second(dyad), 0}});
  } else {
    pin.push_back({joint.second, {0, 0}});
  }
  return pin;
}

/// The pins of the turning joints, those at one place together.
struct Pins {
  std::vector<Pin> pins;
  std::vector<std::optional<std::size_t>> of_joint;

  std::size_t add(const Pin& places) {
    for (std::size_t i = 0; i < pins.size(); ++i) {
      const bool known =
          std::ranges::any_of(places, [&](const auto& at) { return lies_on(at, pins[i]); });
      if (!known) continue;
      pins[i].insert(pins[i].end(), places.begin(), places.end());
      return i;
    }
    pins.push_back(places);
    return pins.size() - 1;
  }
};

Pins pins_of(const Mechanism<double>& mechanism, const JointList& list) {
  Pins all;
  for (std::size_t group = 0; group < list.groups.size(); ++group) {
    const auto& [first_body, bodies, first_joint, joints] = list.groups[group];
    for (int i = first_joint; i < first_joint + joints; ++i) {
      const Joint& joint = list.joints[static_cast<std::size_t>(i)];
      const bool turns = joint.type == JointType::revolute;
      all.of_joint.push_back(
          turns ? std::optional(all.add(places_of(joint, mechanism, static_cast<int>(group))))
                : std::nullopt);
    }
  }
  return all;
}

/// The body of a group with the most joints.
int most_joined(const Group& group, const JointGroup& bodies) {
  int found = bodies.first_body;
  std::ptrdiff_t most = 0;
  for (int body = bodies.first_body; body < bodies.first_body + bodies.bodies; ++body) {
    const auto count = std::ranges::count_if(group.joints, [&](const GroupJoint& joint) {
      return joint.first.body == body || joint.second.body == body;
    });
    if (count > most) found = body;
    most = std::max(most, count);
  }
  return found;
}

}  // namespace

std::vector<std::string> joint_names(const NamedMechanism& mechanism) {
  const JointList list = joints(mechanism.mechanism);
  const Pins all = pins_of(mechanism.mechanism, list);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < list.joints.size(); ++i) {
    const Joint& joint = list.joints[i];
    const auto named = [&](const NamedPoint& point) {
      return all.of_joint[i] && lies_on(point.at, all.pins[*all.of_joint[i]]);
    };
    const auto point = std::ranges::find_if(mechanism.points, named);
    names.push_back(point != mechanism.points.end()
                        ? point->name
                        : mechanism.bodies[static_cast<std::size_t>(joint.first)] + "-" +
                              mechanism.bodies[static_cast<std::size_t>(joint.second)]);
  }
  return names;
}

std::vector<std::string> pin_names(const NamedMechanism& mechanism) {
  const JointList list = joints(mechanism.mechanism);
  const std::vector<std::string> names = joint_names(mechanism);
  std::vector<std::string> pins;
  for (std::size_t i = 0; i < list.joints.size(); ++i) {
    const bool turns = list.joints[i].type == JointType::revolute;
    if (turns && std::ranges::find(pins, names[i]) == pins.end()) pins.push_back(names[i]);
  }
  return pins;
}

std::optional<int> common_body(const Mechanism<double>& mechanism, const Attached<double>& a,
                               const Attached<double>& b) {
  const Pins all = pins_of(mechanism, joints(mechanism));
  const auto bodies_of = [&](const Attached<double>& point) {
    std::vector<int> bodies{point.body};
    for (const Pin& pin : all.pins) {
      if (!lies_on(point, pin)) continue;
      for (const Attached<double>& place : pin) bodies.push_back(place.body);
    }
    return bodies;
  };
  const std::vector<int> of_a = bodies_of(a), of_b = bodies_of(b);
  for (const int body : of_a) {
    if (body != 0 && std::ranges::find(of_b, body) != of_b.end()) return body;
  }
  return std::nullopt;
}

std::vector<std::string> dyad_names(const NamedMechanism& mechanism) {
  const JointList list = joints(mechanism.mechanism);
  const auto names = joint_names(mechanism);
  std::vector<std::string> all;
  for (std::size_t i = 0; i < mechanism.mechanism.dyads.size(); ++i) {
    const JointGroup& group = list.groups[i + 1];
    const Dyad<double>& dyad = mechanism.mechanism.dyads[i];
    if (const auto* links = std::get_if<Group>(&dyad)) {
      all.push_back(mechanism.bodies[static_cast<std::size_t>(most_joined(*links, group))]);
      continue;
    }
    if (std::holds_alternative<GroupRest>(dyad)) {
      all.push_back(all.back());
      continue;
    }
    const bool has_pin =
        std::holds_alternative<Rrr<double>>(dyad) || std::holds_alternative<Cylinder<double>>(dyad);
    all.push_back(has_pin ? names[static_cast<std::size_t>(group.first_joint) + 1]
                          : mechanism.bodies[static_cast<std::size_t>(group.first_body) + 1]);
  }
  return all;
}

}  // namespace cognate::problems
