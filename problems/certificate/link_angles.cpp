#include "problems/certificate/link_angles.hpp"

#include <algorithm>

namespace cognate::problems {
namespace {

using synthesis::Proportions;

constexpr double kLeastDiagonal = 1e-12;  ///< of its square; B may meet D below that

/// numerator/denominator, both not negative, where it is known to be at most `most`.
QuadInterval quotient(const QuadInterval& numerator, const QuadInterval& denominator,
                      const Quad& most) {
  const Quad low =
      denominator.high > 0 ? (QuadInterval(numerator.low) / denominator.high).low : Quad(0);
  if (!(denominator.low > 0)) return {std::min(low, most), most};
  const Quad high = (QuadInterval(numerator.high) / denominator.low).high;
  return {std::min(low, most), std::min(high, most)};
}

/// √share·sine/√(1 − share + share·sine²), which grows with both and is at most 1.
QuadInterval sine_ratio(const QuadInterval& share, const QuadInterval& sine) {
  const auto at = [](const Quad& part, const Quad& sin) -> QuadInterval {
    const QuadInterval top = QuadInterval(part) * square(QuadInterval(sin));
    const QuadInterval beneath = QuadInterval(1) - part + top;
    if (!(beneath.low > 0)) return {0, 1};
    return within(root(top / beneath), 0, 1);
  };
  return {at(share.low, sine.low).low, at(share.high, sine.high).high};
}

/// |2k − 1|.
QuadInterval inner_of(const QuadInterval& frame) {
  QuadInterval twice = QuadInterval(2) * frame - QuadInterval(1);
  if (twice.low >= 0) return twice;
  if (twice.high <= 0) return -twice;
  return {0, twice.magnitude()};
}

QuadInterval product_of(const QuadInterval& frame) {
  const auto at = [](const Quad& k) { return QuadInterval(k) * (QuadInterval(1) - k); };
  const QuadInterval a = at(frame.low), b = at(frame.high);
  const bool holds_half = frame.low <= 0.5 && frame.high >= 0.5;
  return {std::min(a.low, b.low), holds_half ? Quad(0.25) : std::max(a.high, b.high)};
}

/// σ/(1 − σ), which grows with σ.
QuadInterval inverse_of(const QuadInterval& side) {
  const auto at = [](const Quad& s) { return QuadInterval(s) / (QuadInterval(1) - s); };
  return {at(side.low).low, at(side.high).high};
}

}  // namespace

QuadBox::QuadBox(const synthesis::ProportionBox& box)
    : proportions(box.proportions), assembly(box.assembly) {
  for (std::size_t i = 0; i < side.size(); ++i) side[i] = {box.side[i].low, box.side[i].high};
}

QuadBox QuadBox::middle() const {
  QuadBox point = *this;
  for (auto& each : point.side) each = each.middle();
  return point;
}

std::array<QuadBox, 2> QuadBox::halves(int of_side) const {
  std::array<QuadBox, 2> parts{*this, *this};
  const Quad middle = side[of_side].middle();
  parts[0].side[of_side].high = middle;
  parts[1].side[of_side].low = middle;
  return parts;
}

QuadProportions::QuadProportions(const QuadBox& box)
    : frame(box.side[0]),
      crank(QuadInterval(1) - frame),
      product(product_of(frame)),
      inner(inner_of(frame)) {
  if (!box.crank_turns()) {
    difference = box.side[1];
    inverse = inverse_of(box.side[2]);
    return;
  }
  first_cosine = cosine(box.side[1]);
  first_sine = within(sine(box.side[1]), 0, 1);
  second_sine = within(sine(box.side[2]), 0, 1);
  difference = inner * first_cosine;
  inverse = within(cosine(box.side[2]), 0, 1);
}

CrankAngle::CrankAngle(const Quad& at)
    : angle(at), cosine(problems::cosine(at)), sine(problems::sine(at)) {}

/// The triangle B–C–D over a box at one crank angle: D² is the diagonal's square.
struct LinkAngles::Triangle {
  QuadInterval cosine, sine, versine, reach;  ///< of the crank angle; 1 − cos, 1 + cos
  QuadInterval square, diagonal;
  QuadInterval a, b;            ///< ±difference/diagonal and inverse·diagonal
  QuadInterval root_a, root_b;  ///< √(1 − a²), √(1 − b²)
  QuadInterval share;           ///< (inner/diagonal)², where the crank turns
  QuadInterval beneath;         ///< 1/(1 + a b)
};

LinkAngles::LinkAngles(const QuadBox& box)
    : box_(box),
      over_(box),
      at_middle_(box.middle()),
      cosine_low_(cosine(box.side[3].low)),
      cosine_high_(cosine(box.side[3].high)),
      sine_low_(sine(box.side[3].low)),
      sine_high_(sine(box.side[3].high)),
      cosine_middle_(cosine(box.side[3].middle())),
      sine_middle_(sine(box.side[3].middle())) {}

/// The cosine, or the sine, of the crank angle over the box.
QuadInterval LinkAngles::cosine_at(const CrankAngle& at, bool of_sine) const {
  const auto end = [&](const QuadInterval& cosine, const QuadInterval& sine) {
    return of_sine ? at.sine * cosine + at.cosine * sine : at.cosine * cosine - at.sine * sine;
  };
  const Quad shift = at.angle - (of_sine ? Quad(quad_turn() / 4) : Quad(0));
  const QuadInterval& phase = box_.side[3];
  return within(cosine_between({shift + phase.low, shift + phase.high}, end(cosine_low_, sine_low_),
                               end(cosine_high_, sine_high_)),
                -1, 1);
}

/// False where a and b leave the slopes open.
bool LinkAngles::close_triangle(Triangle& t, double sign) const {
  const QuadInterval one(1), two(2);
  t.a = within(QuadInterval(sign) * over_.difference / t.diagonal, -1, 1);
  t.b = within(over_.inverse * t.diagonal, 0, 1);
  if (box_.crank_turns()) {
    t.share = within(square(over_.inner) / t.square, 0, 1);
    const QuadInterval apart = two * over_.product * t.versine / t.square;
    t.root_a = within(root(apart + t.share * square(over_.first_sine)), 0, 1);
    t.root_b =
        within(root(two * over_.product * t.reach + t.square * square(over_.second_sine)), 0, 1);
  } else {
    t.root_a = root((one - t.a) * (one + t.a));
    t.root_b = root((one - t.b) * (one + t.b));
    if (!(t.root_a.low > 0 && t.root_b.low > 0)) return false;
  }
  const QuadInterval sum = one + t.a * t.b;
  if (!(sum.low > 0)) return false;
  t.beneath = one / sum;
  return true;
}

/// Adds the slopes of ±β, cos β = (a + b)/(1 + a b), where δ and σ are sides of the box.
void LinkAngles::add_triangle(const Triangle& t, double sign, double sense, LinkAngle& link) const {
  const QuadInterval by_a = -(t.root_b / t.root_a * t.beneath);
  const QuadInterval by_b = -(t.root_a / t.root_b * t.beneath);
  const QuadInterval by_size = by_b * t.b - by_a * t.a;  // by ln diagonal
  const QuadInterval one(1), two(2), factor(sense);
  link.slope[0] += factor * by_size * (two * over_.frame - one) * t.reach / t.square;
  link.slope[1] = factor * QuadInterval(sign) * by_a / t.diagonal;
  link.slope[2] = factor * by_b * t.diagonal * square(one + over_.inverse);
  link.slope[3] += factor * by_size * over_.product * t.sine / t.square;
}

/// The same where the sides are the angles ξ and η.
void LinkAngles::add_turning(const Triangle& t, double sign, double sense, LinkAngle& link) const {
  const QuadInterval two(2), factor(sense), doubled = two * over_.product;
  const double half = box_.proportions == Proportions::frame_shortest ? -1 : 1;
  // 1 − a² ≥ 2κ(1 − cos θ)/D² and 1 − b² ≥ 2κ(1 + cos θ), κ the product of frame and crank.
  const QuadInterval most_a = root(t.square * t.versine / doubled);
  const QuadInterval most_b = root(t.reach / doubled);
  const QuadInterval versine_by_a = quotient(t.versine, t.root_a, most_a.high);
  const QuadInterval reach_by_b = quotient(t.reach, t.root_b, most_b.high);
  const QuadInterval a_by_k = QuadInterval(-sign * half) * over_.first_cosine * t.root_b *
                              t.beneath * versine_by_a / (t.diagonal * t.square);
  const QuadInterval b_by_k = -(t.root_a * t.beneath * reach_by_b * over_.inverse *
                                (two * over_.frame - QuadInterval(1)) / t.diagonal);
  link.slope[0] += factor * (a_by_k + b_by_k);
  link.slope[1] =
      QuadInterval(sign * sense) * t.root_b * t.beneath * sine_ratio(t.share, over_.first_sine);
  link.slope[2] = factor * t.root_a * t.beneath * sine_ratio(t.square, over_.second_sine);
  const auto sine_by = [&](const QuadInterval& under, const QuadInterval& most) {
    const QuadInterval size{t.sine.low > 0    ? t.sine.low
                            : t.sine.high < 0 ? Quad(-t.sine.high)
                                              : Quad(0),
                            t.sine.magnitude()};
    const Quad high = quotient(size, under, most.high).high;
    const Quad low = under.high > 0 ? (QuadInterval(size.low) / under.high).low : Quad(0);
    if (t.sine.low >= 0) return QuadInterval(std::min(low, high), high);
    if (t.sine.high <= 0) return QuadInterval(-high, -std::min(low, high));
    return QuadInterval(-high, high);
  };
  const QuadInterval sine_by_a = sine_by(t.root_a, root(t.square * t.reach / doubled));
  const QuadInterval sine_by_b = sine_by(t.root_b, root(t.versine / doubled));
  link.slope[3] += factor * over_.product / t.square * t.beneath *
                   (t.a * t.root_b * sine_by_a - t.b * t.root_a * sine_by_b);
}

/// At the middle of the box, from the law of cosines.
QuadComplex LinkAngles::direction(const CrankAngle& angle, bool rocker) const {
  const QuadProportions& p = at_middle_;
  const QuadInterval one(1), sign(rocker ? -1 : 1);
  const QuadInterval cosine = angle.cosine * cosine_middle_ - angle.sine * sine_middle_;
  const QuadInterval sine = angle.sine * cosine_middle_ + angle.cosine * sine_middle_;
  const QuadComplex diagonal{p.frame - p.crank * cosine, -(p.crank * sine)};
  const QuadInterval size = root(squared_size(diagonal));
  const QuadInterval a = sign * p.difference / size, b = p.inverse * size;
  const QuadInterval turn_cosine = within((a + b) / (one + a * b), -1, 1);
  const QuadInterval turn_sine =
      within(root((one - square(a)) * (one - square(b))) / (one + a * b), 0, 1);
  const QuadComplex turn{turn_cosine, QuadInterval(double(box_.assembly)) * sign * turn_sine};
  const QuadComplex unit = diagonal * turn;
  return {sign * unit.re / size, sign * unit.im / size};
}

LinkAngle LinkAngles::at(const CrankAngle& angle, bool rocker) const {
  const QuadInterval one(1), two(2);
  const double sign = rocker ? -1 : 1, sense = sign * box_.assembly;
  Triangle t;
  t.cosine = cosine_at(angle, false);
  t.sine = cosine_at(angle, true);
  t.versine = within(one - t.cosine, 0, 2);
  t.reach = within(one + t.cosine, 0, 2);
  const QuadInterval shorter = one - two * over_.product * t.reach;
  const QuadInterval longer = square(over_.inner) + two * over_.product * t.versine;
  t.square = {std::max({Quad(0), shorter.low, longer.low}),
              std::min({Quad(1), shorter.high, longer.high})};
  LinkAngle link;
  link.diagonal_square = t.square;
  if (!(t.square.low > kLeastDiagonal)) return link;
  t.diagonal = root(t.square);
  const QuadInterval cosine = over_.difference / t.diagonal;
  link.closes = cosine.low <= 1 && cosine.high >= -1 && (over_.inverse * t.diagonal).low <= 1;
  if (!link.closes || !(over_.product.low > 0) || !close_triangle(t, sign)) return link;
  link.slope[0] = t.sine / t.square;
  link.slope[3] = over_.crank * (over_.crank - over_.frame * t.cosine) / t.square;
  if (box_.crank_turns()) {
    add_turning(t, sign, sense, link);
  } else {
    add_triangle(t, sign, sense, link);
  }
  link.middle = direction(angle, rocker);
  link.known = true;
  return link;
}

}  // namespace cognate::problems
