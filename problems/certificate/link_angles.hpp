/// @file Where coupler and rocker point over a box of proportions, in intervals of 113 bits.
///
/// With frame + crank = 1 a box holds the frame k, two numbers for the lengths of coupler and
/// rocker, and the angle of the crank from A→D; synthesis/bounds/proportion_box.hpp says which. The
/// law of cosines gives the angle between the diagonal B–D and a link, the chain rule its
/// derivatives, which are bounded wherever the diagonal is not zero: next to change points as
/// quotients such as |sin θ|/√(1 − a²) have limits of their own. Nothing but the data structures is
/// shared with the bounds that are checked.
#pragma once

#include <array>

#include "problems/certificate/quad_interval.hpp"
#include "synthesis/bounds/proportion_box.hpp"

namespace cognate::problems {

/// A box of proportions and phase.
struct QuadBox {
  std::array<QuadInterval, 4> side;
  synthesis::Proportions proportions = synthesis::Proportions::any;
  int assembly = 1;  ///< 1 open, −1 crossed

  explicit QuadBox(const synthesis::ProportionBox& box);

  bool crank_turns() const { return proportions != synthesis::Proportions::any; }
  QuadBox middle() const;
  std::array<QuadBox, 2> halves(int of_side) const;
};

/// What a box says of all crank angles: proportions with frame + crank = 1.
struct QuadProportions {
  explicit QuadProportions(const QuadBox& box);

  QuadInterval frame, crank;
  QuadInterval product;     ///< frame·crank
  QuadInterval inner;       ///< |frame − crank|
  QuadInterval difference;  ///< coupler − rocker
  QuadInterval inverse;     ///< 1/(coupler + rocker)
  /// Of sides 1 and 2, where they are angles.
  QuadInterval first_cosine, first_sine, second_sine;
};

/// Crank directions that a problem prescribes, as cosine and sine of the angle less the phase.
struct CrankAngle {
  Quad angle;
  QuadInterval cosine, sine;

  explicit CrankAngle(const Quad& at);
};

/// A link's angle over a box: at the middle its direction, and how fast it changes by each side.
struct LinkAngle {
  QuadComplex middle;
  std::array<QuadInterval, 4> slope;
  QuadInterval diagonal_square;
  bool known = false;  ///< whether middle and slopes are; else nothing is
  bool closes = true;  ///< false: surely not, over the whole box
};

/// The angles of a link over one box.
class LinkAngles {
 public:
  explicit LinkAngles(const QuadBox& box);

  /// Of the coupler, B→C, or the rocker, D→C, at one crank angle.
  LinkAngle at(const CrankAngle& angle, bool rocker) const;

  const QuadProportions& proportions() const { return over_; }

 private:
  struct Triangle;

  QuadInterval cosine_at(const CrankAngle& angle, bool sine) const;
  bool close_triangle(Triangle& t, double sign) const;
  void add_triangle(const Triangle& t, double sign, double sense, LinkAngle& link) const;
  void add_turning(const Triangle& t, double sign, double sense, LinkAngle& link) const;
  QuadComplex direction(const CrankAngle& angle, bool rocker) const;

  QuadBox box_;
  QuadProportions over_, at_middle_;
  QuadInterval cosine_low_, cosine_high_, sine_low_, sine_high_;  ///< of the phase's ends
  QuadInterval cosine_middle_, sine_middle_;
};

}  // namespace cognate::problems
