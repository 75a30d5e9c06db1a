#include "analysis/machine/pieces.hpp"

#include <algorithm>
#include <cmath>

namespace cognate::machine {
namespace {

/// Parts of the period. The ends of a load's interval belong to it to within 1e-12 of a radian.
constexpr double kSlack = 1e-12;

}  // namespace

Pieces::Pieces(const Machine& machine, double mark)
    : period_(machine.period), slack_(kSlack * period_), cuts_(machine.breaks) {
  cuts_.insert(cuts_.end(), {0, mark, period_});
  std::ranges::sort(cuts_);
  const auto close = [&](double a, double b) { return b - a <= 4 * slack_; };
  cuts_.erase(std::unique(cuts_.begin(), cuts_.end(), close), cuts_.end());
  cuts_.back() = period_;
}

double Pieces::inside(std::size_t piece, double phi) const {
  return std::clamp(phi, cuts_[piece] + slack_, cuts_[piece + 1] - slack_);
}

Place Pieces::place(double phi, int direction) const {
  Place place;
  place.turn = std::floor(phi / period_);
  place.phi = std::clamp(phi - place.turn * period_, 0.0, period_);
  const auto above = std::ranges::upper_bound(cuts_, place.phi + slack_);
  place.piece = static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(above - cuts_.begin() - 1, 0, std::ssize(cuts_) - 2));
  if (direction < 0 && place.phi - from(place.piece) <= slack_) move_on(place, direction);
  if (direction > 0 && to(place.piece) - place.phi <= slack_) move_on(place, direction);
  return place;
}

void Pieces::move_on(Place& place, int direction) const {
  if (direction > 0) {
    if (++place.piece == count()) {
      place.piece = 0;
      ++place.turn;
    }
    place.phi = from(place.piece);
  } else {
    if (place.piece == 0) {
      place.piece = count();
      --place.turn;
    }
    --place.piece;
    place.phi = to(place.piece);
  }
}

}  // namespace cognate::machine
