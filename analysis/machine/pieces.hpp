/// @file The stretches of the drive's coordinate over which a machine is smooth.
#pragma once

#include <cstddef>
#include <vector>

#include "analysis/machine/machine.hpp"

namespace cognate::machine {

/// Where a drive stands: in which period, in which of its pieces, and its φ there in [0, period].
struct Place {
  double turn = 0;  ///< a whole number
  std::size_t piece = 0;
  double phi = 0;
};

/// The period, cut at the breaks, at 0 and where requested.
class Pieces {
 public:
  /// Cuts at `mark`, in [0, period), as well.
  explicit Pieces(const Machine& machine, double mark = 0);

  std::size_t count() const { return cuts_.size() - 1; }
  double from(std::size_t piece) const { return cuts_[piece]; }
  double to(std::size_t piece) const { return cuts_[piece + 1]; }

  /// `phi`, moved off the ends of the piece by so little that no result shows it: at an end a
  /// torque that jumps has the value of one side or of neither.
  double inside(std::size_t piece, double phi) const;

  /// Where a drive at `phi`, counted from turn to turn, stands when it moves in `direction` (±1).
  Place place(double phi, int direction) const;

  /// The same place after it has reached an end of its piece and moves on in `direction`; the next
  /// piece of a drive that turns round is its own.
  void move_on(Place& place, int direction) const;

  /// φ counted from turn to turn.
  double counted(const Place& place) const { return place.turn * period_ + place.phi; }

 private:
  double period_;
  double slack_;
  std::vector<double> cuts_;
};

/// Goes once round from `place`, forwards, which moves along: in each piece `stepper` begins anew
/// with `y`, and `through(end of the piece)` takes it there. What that returns ends the round where
/// it is not its type's first value.
template <class Stepper, class State, class Through>
auto integrate_round(const Pieces& pieces, Place& place, Stepper& stepper, State& y,
                     Through&& through) {
  using End = decltype(through(0.0));
  for (std::size_t i = 0; i < pieces.count(); ++i) {
    if (i > 0) pieces.move_on(place, 1);
    stepper.start(place.phi, y);
    const End end = through(pieces.to(place.piece));
    if (end != End{}) return end;
    y = stepper.y();
  }
  return End{};
}

}  // namespace cognate::machine
