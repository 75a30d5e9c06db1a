#include "analysis/mechanism/sliding_pairs.hpp"

#include <algorithm>
#include <type_traits>

namespace cognate {
namespace {

using Pairs = std::vector<SlidingPair>;

Pairs pairs_of(const Crank<double>&) {
  return {};
}

Pairs pairs_of(const DrivingSlider<double>&) {
  return {};
}

Pairs pairs_of(const FloatingLink<double>& link) {
  return {on_guide(2, link.first), on_guide(3, link.second)};
}

Pairs pairs_of(const DrivingRod<double>&) {
  return {};
}

// The dyads, whose bodies are n and n + 1.

Pairs pairs_of(const Rrr<double>&, int) {
  return {};
}

Pairs pairs_of(const Rrp<double>& dyad, int n) {
  return {on_guide(n + 1, dyad.guide)};
}

Pairs pairs_of(const Rpr<double>&, int n) {
  return {{n, {n + 1, {0, 0}}, {1, 0}}};
}

Pairs pairs_of(const Prp<double>& dyad, int n) {
  return {on_guide(n, dyad.first), on_guide(n + 1, dyad.second)};
}

Pairs pairs_of(const Rpp<double>& dyad, int n) {
  return {{n, {n + 1, {0, 0}}, dyad.slot}, on_guide(n + 1, dyad.guide)};
}

Pairs pairs_of(const Cylinder<double>&, int) {
  return {};
}

/// Of a body with several slides the first.
Pairs pairs_of(const Group& group, int) {
  Pairs pairs;
  for (const GroupJoint& joint : group.joints) {
    const int slider = joint.second.body;
    const bool is_known = std::ranges::find(pairs, slider, &SlidingPair::slider) != pairs.end();
    if (joint.slides && !is_known) pairs.push_back({slider, joint.first, joint.along_first});
  }
  return pairs;
}

Pairs pairs_of(const GroupRest&, int) {
  return {};
}

/// The bodies after whose angles those of a dyad's two bodies follow; −1 for one that turns by
/// itself.
struct Followed {
  int first = -1;
  int second = -1;
};

Followed followed_by(const Rrr<double>&) {
  return {};
}

Followed followed_by(const Rrp<double>& dyad) {
  return {-1, dyad.guide.body};
}

Followed followed_by(const Rpr<double>&) {
  return {};
}

Followed followed_by(const Prp<double>& dyad) {
  return {dyad.first.body, dyad.second.body};
}

Followed followed_by(const Rpp<double>& dyad) {
  return {dyad.guide.body, dyad.guide.body};
}

Followed followed_by(const Cylinder<double>&) {
  return {};
}

/// Appends to `turns` what the bodies of a group do: one that slides on another turns with it.
void append_turns(const Group& group, std::vector<bool>& turns) {
  turns.resize(turns.size() + group.drawn.size(), true);
  for (std::size_t pass = 0; pass < group.drawn.size(); ++pass) {
    for (const GroupJoint& joint : group.joints) {
      const auto first = static_cast<std::size_t>(joint.first.body);
      const auto second = static_cast<std::size_t>(joint.second.body);
      const bool both = turns[first] && turns[second];
      if (joint.slides) turns[first] = turns[second] = both;
    }
  }
}

}  // namespace

SlidingPair on_guide(int slider, const Guide<double>& guide) {
  return {slider, {guide.body, guide.through}, guide.direction};
}

Pairs sliding_pairs(const Mechanism<double>& mechanism) {
  Pairs all = std::visit([](const auto& drive) { return pairs_of(drive); }, mechanism.drive);
  int body = first_body(mechanism, 0);
  for (const auto& dyad : mechanism.dyads) {
    const Pairs pairs = std::visit([&](const auto& group) { return pairs_of(group, body); }, dyad);
    all.insert(all.end(), pairs.begin(), pairs.end());
    body += 2;
  }
  return all;
}

std::vector<bool> turning_bodies(const Mechanism<double>& mechanism) {
  std::vector<bool> turns(static_cast<std::size_t>(first_body(mechanism, 0)), false);
  turns[1] = !std::holds_alternative<DrivingSlider<double>>(mechanism.drive);
  const auto append = [&](int followed) {
    turns.push_back(followed < 0 || turns[static_cast<std::size_t>(followed)]);
  };
  const auto append_all = [&]<class Closing>(const Closing& dyad) {
    if constexpr (std::is_same_v<Closing, Group>) {
      append_turns(dyad, turns);
    } else if constexpr (!std::is_same_v<Closing, GroupRest>) {
      const Followed followed = followed_by(dyad);
      append(followed.first);
      append(followed.second);
    }
  };
  for (const auto& dyad : mechanism.dyads) std::visit(append_all, dyad);
  return turns;
}

}  // namespace cognate
