#include "analysis/mechanism/sliding_pairs.hpp"

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
  for (const auto& dyad : mechanism.dyads) {
    const auto followed = std::visit([](const auto& group) { return followed_by(group); }, dyad);
    append(followed.first);
    append(followed.second);
  }
  return turns;
}

}  // namespace cognate
