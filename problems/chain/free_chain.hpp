/// @file A chain with derivatives by its free parameters, for models.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "analysis/numbers/angle.hpp"
#include "problems/chain/space.hpp"
#include "synthesis/chain/heading.hpp"
#include "synthesis/chain/sweep.hpp"

namespace cognate::problems {

/// A dyad and an angle of the crank at which its transmission angle is limited.
struct TransmissionCheck {
  int joint = 0;  ///< its line
  double crank = 0;
};

/// A chain with its derivatives by the free parameters.
class FreeChain {
 public:
  FreeChain(const ChainSpace& space, std::span<const double> parameters,
            std::span<const double> side)
      : space_(space),
        view_{space.lines.data(), static_cast<int>(space.lines.size()), parameters.data(),
              side.data()} {}

  /// The points with the crank at this angle; what follows speaks of the last.
  const Vec2d* at(double crank) { return at(unit_vector(crank)); }
  /// The same with the crank in this direction.
  const Vec2d* at(const Vec2d& direction) {
    synthesis::place_next(view_, direction, place_);
    return place_.at;
  }

  /// Of `direction`·P, P the point of line `line`: fills `row` and returns the derivative by the
  /// crank's angle.
  double slope(int line, const Vec2d& direction, double* row) {
    clear();
    seed_[static_cast<std::size_t>(line)] = direction;
    return swept(line, row);
  }

  /// Of the angle of the way from the point of line `from` to that of `to`.
  double angle_slope(int from, int to, double* row) {
    clear();
    const Vec2d along = way(from, to);
    const Vec2d across = (1 / squared_norm(along)) * perp(along);
    seed_[static_cast<std::size_t>(to)] = across;
    seed_[static_cast<std::size_t>(from)] = -across;
    return swept(std::max(from, to), row);
  }

  /// The angle from `wanted` to the heading of line `line`, −π … π.
  double turned(int line, const Vec2d& wanted) const {
    return angle_of(conj(wanted) * synthesis::heading(view_, place_, line));
  }

  /// `weight` times its derivatives.
  double heading_slope(int line, double weight, double* row) {
    clear();
    synthesis::seed_heading(view_, place_, line, weight, seed_.data(), gradient_.data());
    return swept(line, row);
  }

  /// From the point of line `from` to that of `to`.
  Vec2d way(int from, int to) const { return place_.at[to] - place_.at[from]; }

  /// How far the slider of line `to` is along its guide `from`.
  double displacement(int from, int to) const { return dot(place_.axis[from], way(from, to)); }

  /// Its derivatives.
  double displacement_slope(int from, int to, double* row) {
    clear();
    seed_[static_cast<std::size_t>(to)] = place_.axis[from];
    seed_[static_cast<std::size_t>(from)] = -place_.axis[from];
    return swept(to, row);
  }

  /// cos μ of a joint.
  double cosine(const TransmissionCheck& check) {
    at(check.crank);
    return synthesis::transmission_cosine(view_, place_, check.joint);
  }

  /// Its derivatives; returns that by the crank's angle.
  double cosine_slope(const TransmissionCheck& check, double cosine, double* row) {
    clear();
    synthesis::seed_transmission(view_, place_, check.joint, cosine, 1.0, seed_.data(),
                                 gradient_.data());
    return swept(synthesis::last_seeded(view_, check.joint), row);
  }

 private:
  double swept(int last, double* row) {
    const double turn = synthesis::sweep_back(view_, place_, last, seed_.data(), gradient_.data());
    take(row);
    return turn;
  }

  void clear() {
    seed_.fill({});
    gradient_.fill(0);
  }

  void take(double* row) const {
    for (const int parameter : space_.free) {
      *row++ = gradient_[static_cast<std::size_t>(parameter)];
    }
  }

  const ChainSpace& space_;
  synthesis::ChainView<double> view_;
  synthesis::ChainPlace<double> place_;
  std::array<Vec2d, synthesis::kMostLines> seed_{};
  std::array<double, synthesis::kMostChainParameters> gradient_{};
};

/// With what the crank angles of all checks turn.
struct CheckTurn {
  std::size_t column;  ///< of the unknown
  double angle;        ///< by which they have turned
};

/// Adds `fresh` to the checks that are watched. Those of three-pin links stand in the order of the
/// crank, along which such links are led.
void watch(const ChainSpace& space, const std::vector<TransmissionCheck>& fresh,
           std::vector<TransmissionCheck>& watched);

/// Two constraints for each check: limit ∓ cos μ ≥ 0, of |cos μ|. Their rows of `jacobian`, where
/// it is not empty, have `columns` entries, the free parameters first. A dyad that does not close
/// violates.
void transmission_constraints(FreeChain& chain, double limit,
                              std::span<const TransmissionCheck> checks, std::size_t columns,
                              std::span<double> c, std::span<double> jacobian,
                              std::optional<CheckTurn> turn = std::nullopt);

}  // namespace cognate::problems
