#include <cmath>

#include "analysis/mechanism/kinematics.hpp"
#include "tests/stress/chain_accuracy.hpp"

namespace cognate::stress {
namespace {

using Random = std::mt19937_64;

double uniform(Random& random, double from, double to) {
  return std::uniform_real_distribution<double>(from, to)(random);
}

Vec2d anywhere(Random& random) {
  return {uniform(random, -1, 1), uniform(random, -1, 1)};
}

Vec2d unit(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

Assembly assembly(Random& random) {
  return random() % 2 == 0 ? Assembly::open : Assembly::crossed;
}

/// Inwards of the limit by `distance`, one in ten beyond it.
double inwards(double distance, Random& random) {
  return uniform(random, -0.1, 1) < 0 ? -distance : distance;
}

/// A crank with its pin as body 1.
ChainPosition crank(Random& random) {
  return {{Crank<double>{anywhere(random), uniform(random, 0.2, 1)}, {}},
          unit(uniform(random, -3.15, 3.15))};
}

Attached<double> pin(const ChainPosition& at) {
  return {1, {std::get<Crank<double>>(at.mechanism.drive).length, 0}};
}

/// Where a point of the chain stands, rounded.
Vec2d place(const ChainPosition& at, const Attached<double>& point) {
  MechanismMotion<0> motion(at.mechanism);
  motion.move_to(DrivePosition<double>{at.crank, 0});
  return motion.point(point)[0];
}

double length(const Vec2d& v) {
  return std::hypot(v.x, v.y);
}

/// An RRR on `from` and a point of the frame, stretched or folded but for `distance`.
void add_rrr(ChainPosition& at, const Attached<double>& from, double distance, Random& random) {
  const Vec2d pivot = anywhere(random);
  const double span = length(pivot - place(at, from));
  const double gap = inwards(distance, random), share = uniform(random, 0.2, 0.8);
  // Stretched: l₁ + l₂ is more than the span; folded: l₁ − l₂ is less.
  const bool stretched = random() % 2 == 0;
  const double first = stretched ? share * span : (1 + share) * span;
  const double second = stretched ? (1 + gap) * span - first : first - (1 - gap) * span;
  at.mechanism.dyads.push_back(Rrr<double>{from, {0, pivot}, first, second, assembly(random)});
}

ChainPosition rrr(double distance, Random& random) {
  ChainPosition at = crank(random);
  add_rrr(at, pin(at), distance, random);
  return at;
}

/// The second of two, on a point of the first one's coupler.
ChainPosition second_rrr(double distance, Random& random) {
  ChainPosition at = crank(random);
  add_rrr(at, pin(at), 0.3, random);
  const double gap = uniform(random, 0.2, 0.5);
  std::get<Rrr<double>>(at.mechanism.dyads[0]).first_length += gap;
  std::get<Rrr<double>>(at.mechanism.dyads[0]).second_length += gap;
  add_rrr(at, {2, anywhere(random)}, distance, random);
  return at;
}

/// The link across the guide but for `distance`.
ChainPosition rrp(double distance, Random& random) {
  ChainPosition at = crank(random);
  Guide<double> guide{0, anywhere(random), unit(uniform(random, -3.15, 3.15)), 0};
  const double l = uniform(random, 0.2, 1);
  const double reach = (random() % 2 == 0 ? l : -l) * (1 - inwards(distance, random));
  guide.offset = reach - cross(guide.direction, guide.through - place(at, pin(at)));
  at.mechanism.dyads.push_back(Rrp<double>{pin(at), l, guide, assembly(random)});
  return at;
}

/// The block as far from the pivot as the bar, but for `distance`.
ChainPosition rpr(double distance, Random& random) {
  ChainPosition at = crank(random);
  const Vec2d pivot = anywhere(random);
  const double span = length(place(at, pin(at)) - pivot) * (1 - inwards(distance, random));
  at.mechanism.dyads.push_back(
      Rpr<double>{pin(at), {0, pivot}, random() % 2 == 0 ? span : -span, assembly(random)});
  return at;
}

/// Guides of the crank and of the frame at the angle `distance`.
ChainPosition prp(double distance, Random& random) {
  ChainPosition at = crank(random);
  const Vec2d on_crank = unit(uniform(random, -3.15, 3.15));
  const Vec2d across = at.crank * on_crank + distance * perp(at.crank * on_crank);
  at.mechanism.dyads.push_back(
      Prp<double>{{1, anywhere(random), on_crank, uniform(random, -0.5, 0.5)},
                  {0, anywhere(random), across, uniform(random, -0.5, 0.5)}});
  auto& second = std::get<Prp<double>>(at.mechanism.dyads.back()).second;
  second.direction = (1 / length(across)) * across;
  return at;
}

/// A slot at the angle `distance` from its guide.
ChainPosition rpp(double distance, Random& random) {
  ChainPosition at = crank(random);
  const Guide<double> guide{0, anywhere(random), unit(uniform(random, -3.15, 3.15)),
                            uniform(random, -0.5, 0.5)};
  at.mechanism.dyads.push_back(
      Rpp<double>{pin(at), {std::cos(distance), std::sin(distance)}, guide});
  return at;
}

}  // namespace

std::vector<ChainFamily> chain_families() {
  return {{"RRR on the crank", "relative gap to stretched or folded", rrr},
          {"RRR on a coupler", "relative gap to stretched or folded", second_rrr},
          {"RRP", "relative gap to across the guide", rrp},
          {"RPR", "relative gap to the offset", rpr},
          {"PRP", "angle between the guides, rad", prp},
          {"RPP", "angle of the slot to the guide, rad", rpp}};
}

}  // namespace cognate::stress
