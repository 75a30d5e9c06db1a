#include "tests/stress/ranges/range_cases.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace cognate::stress {
namespace {

constexpr long double kEps = std::numeric_limits<double>::epsilon();

/// Of a four-bar: how far the sums that the tie makes equal are apart, the greatest of them.
long double sum_gap(const SingleLoop& l) {
  const long double a = l.crank, b = l.coupler, c = l.rocker, d = l.frame_x;
  const long double gaps[] = {std::abs(c + d - a - b), std::abs(b + d - a - c),
                              std::abs(a + d - b - c)};
  switch (l.tie) {
    case Tie::single:
      return gaps[l.equal_sum - 1];
    case Tie::parallelogram:
      return std::max(gaps[0], gaps[2]);
    case Tie::kite_b_on_d:
      return std::max(gaps[0], gaps[1]);
    case Tie::kite_c_on_a:
      return std::max(gaps[1], gaps[2]);
    case Tie::rhombus:
      return std::max({gaps[0], gaps[1], gaps[2]});
    default:
      return 1;
  }
}

/// Not above `length`: mechanisms with slides count gaps in parts of it.
long double power_of_two(double length) {
  return std::ldexp(1.0L, std::ilogb(length));
}

}  // namespace

/// A relative distance from a tie: none, or 1e-3 … 1e-15 to either side.
double LoopCases::nearness() {
  if (chance(0.3)) return 0;
  return (chance(0.5) ? 1 : -1) * std::pow(10, -between(3, 15));
}

void LoopCases::set_drive(SingleLoop& loop) {
  constexpr double kRound[] = {0, 90, 180, 270};
  loop.start = chance(0.5) ? kRound[one_of(4)] : between(-400, 400);
  const double length = chance(0.6) ? 360 : chance(0.5) ? between(20, 350) : 720;
  loop.end = loop.start + (chance(0.8) ? length : -length);
  loop.side = chance(0.5) ? 1 : -1;
}

/// Decides by the gap between sums whether they count as equal; false where the tolerance is so
/// near that the last bit decides. `unit`: that of which the gap is a part.
bool LoopCases::settle(LoopCase& drawn, long double gap, long double unit) {
  const long double parts = gap / (kEps * unit);
  // The places of a bar's block decide where it has no offset, and are rounded once more.
  const bool is_bar =
      drawn.loop.type == LoopType::guide_bar || drawn.loop.type == LoopType::oscillating_block;
  if (parts > 13 && parts < (is_bar ? 36 : 19)) return false;
  if (parts >= 19) drawn.loop.tie = Tie::none;
  drawn.is_near_tie = true;
  drawn.nearness = static_cast<double>(parts * kEps);
  return true;
}

LoopCase LoopCases::four_bar() {
  LoopCase drawn;
  SingleLoop& l = drawn.loop;
  if (chance(0.5)) {
    l.crank = between(0.3, 3), l.coupler = between(0.3, 3), l.rocker = between(0.3, 3);
    const double frame = between(0.3, 3), turn = chance(0.5) ? 0 : between(-3, 3);
    l.frame_x = frame * std::cos(turn), l.frame_y = frame * std::sin(turn);
    return drawn;
  }
  l.crank = dyadic(), l.coupler = dyadic(), l.rocker = dyadic(), l.frame_x = dyadic();
  l.tie = static_cast<Tie>(1 + one_of(5));
  if (l.crank == l.coupler || l.crank == l.rocker || l.coupler == l.rocker) return four_bar();
  switch (l.tie) {
    case Tie::single:
      l.equal_sum = 1 + one_of(3);
      l.frame_x = l.equal_sum == 1   ? l.crank + l.coupler - l.rocker
                  : l.equal_sum == 2 ? l.crank + l.rocker - l.coupler
                                     : l.coupler + l.rocker - l.crank;
      break;
    case Tie::parallelogram:
      l.rocker = l.crank, l.frame_x = l.coupler;
      break;
    case Tie::kite_b_on_d:
      l.frame_x = l.crank, l.rocker = l.coupler;
      break;
    case Tie::kite_c_on_a:
      l.coupler = l.crank, l.frame_x = l.rocker;
      break;
    default:
      l.coupler = l.rocker = l.frame_x = l.crank;
  }
  if (!(l.frame_x > 0.1)) return four_bar();
  double* lengths[] = {&l.crank, &l.coupler, &l.rocker, &l.frame_x};
  *lengths[one_of(4)] *= 1 + nearness();
  const long double longest = std::max({l.crank, l.coupler, l.rocker, l.frame_x});
  return settle(drawn, sum_gap(l), longest) ? drawn : four_bar();
}

LoopCase LoopCases::slider_crank() {
  LoopCase drawn;
  SingleLoop& l = drawn.loop;
  l.type = chance(0.6) ? LoopType::slider_crank : LoopType::fixed_block;
  l.direction = chance(0.5) ? 0 : between(-180, 180);
  l.crank = dyadic(), l.coupler = dyadic(), l.offset = chance(0.2) ? 0 : (one_of(200) - 100) / 64.0;
  if (chance(0.5)) {
    l.crank = between(0.3, 3), l.coupler = between(0.3, 3), l.offset *= between(0.5, 1.5);
    return drawn;
  }
  l.tie = Tie::single;
  const bool crank_turns = chance(0.5);
  double &longer = crank_turns ? l.coupler : l.crank, &shorter = crank_turns ? l.crank : l.coupler;
  longer = shorter + std::abs(l.offset);
  double* lengths[] = {&longer, &shorter, &l.offset};
  *lengths[one_of(3)] *= 1 + nearness();
  const long double gap = std::abs(static_cast<long double>(longer) - shorter -
                                   std::abs(static_cast<long double>(l.offset)));
  const long double unit = power_of_two(longer);
  const bool clear = l.offset != 0 || longer > shorter || gap < 13 * kEps * unit;
  return clear && settle(drawn, gap, unit) ? drawn : slider_crank();
}

LoopCase LoopCases::guide_bar() {
  LoopCase drawn;
  SingleLoop& l = drawn.loop;
  l.type = chance(0.6) ? LoopType::guide_bar : LoopType::oscillating_block;
  l.crank = dyadic(), l.frame_x = dyadic(), l.offset = chance(0.3) ? 0 : (one_of(200) - 100) / 64.0;
  if (chance(0.5)) {
    l.crank = between(0.3, 3);
    const double turn = chance(0.5) ? 0 : between(-3, 3), frame = l.frame_x * between(0.5, 1.5);
    l.frame_x = frame * std::cos(turn), l.frame_y = frame * std::sin(turn);
    return drawn;
  }
  l.tie = Tie::single;
  double &longer = chance(0.5) ? l.crank : l.frame_x,
         &shorter = &longer == &l.crank ? l.frame_x : l.crank;
  longer = shorter + std::abs(l.offset);
  double* lengths[] = {&longer, &shorter, &l.offset};
  *lengths[one_of(3)] *= 1 + nearness();
  const long double gap = std::abs(std::abs(static_cast<long double>(longer) - shorter) -
                                   std::abs(static_cast<long double>(l.offset)));
  return settle(drawn, gap, power_of_two(std::max(longer, shorter))) ? drawn : guide_bar();
}

LoopCase LoopCases::double_slider() {
  LoopCase drawn;
  SingleLoop& l = drawn.loop;
  constexpr LoopType kTypes[] = {LoopType::scotch_yoke, LoopType::tangent_generator,
                                 LoopType::elliptic_trammel, LoopType::oldham_coupling};
  l.type = kTypes[one_of(4)];
  l.crank = between(0.3, 3);
  l.offset = (chance(0.5) ? 1 : -1) * between(0.1, 2);
  l.direction = chance(0.5) ? 0 : between(-180, 180);
  l.slot = chance(0.5) ? 90 : between(20, 160);
  l.frame_x = between(0.2, 1), l.frame_y = between(0.2, 1);
  return drawn;
}

LoopCase LoopCases::next() {
  const double share = between(0, 1);
  LoopCase drawn = share < 0.5    ? four_bar()
                   : share < 0.7  ? slider_crank()
                   : share < 0.88 ? guide_bar()
                                  : double_slider();
  const int side = drawn.loop.side;
  set_drive(drawn.loop);
  if (drawn.loop.type == LoopType::guide_bar || drawn.loop.type == LoopType::oscillating_block) {
    if (drawn.loop.offset == 0) drawn.loop.side = side;
  }
  return drawn;
}

}  // namespace cognate::stress
