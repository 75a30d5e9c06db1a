/// @file Gear trains of any structure: speeds by Willis' equation, exactly.
#pragma once

#include <array>
#include <vector>

#include "analysis/train/fraction.hpp"

namespace cognate::train {

/// What does not turn, as carrier of gears on fixed axes.
inline constexpr int kFrame = -1;

/// Two gears in mesh whose axes `carrier` holds. In its frame z_a (ω_a − ω_c) = s z_b (ω_b − ω_c),
/// s = −1 where they turn against each other (external teeth), 1 where they turn alike (one has
/// internal teeth).
struct Mesh {
  std::array<int, 2> gears{};  ///< members
  std::array<int, 2> teeth{};
  int carrier = kFrame;
  int sense = -1;
  double efficiency = 1;  ///< of the power that it passes in the carrier's frame

  /// s z_b, so that both gears and the carrier have the coefficients z_a, −s z_b, s z_b − z_a.
  int signed_teeth() const { return sense * teeth[1]; }
};

/// Members are numbered from 0: shafts with all that is fast to them, planets, carriers.
struct GearTrain {
  int members = 0;
  std::vector<Mesh> meshes;
  std::vector<int> fixed;
  std::vector<std::array<int, 2>> joined;  ///< by clutches: they turn as one

  std::size_t conditions() const { return meshes.size() + fixed.size() + joined.size(); }
};

/// The speeds that those of `inputs` determine.
struct TrainSpeeds {
  /// Of each member, as multiples of the speeds of the inputs.
  std::vector<std::vector<Fraction>> shares;
  std::vector<int> undetermined;  ///< members whose speed no input determines
  std::vector<int> excess;        ///< places of inputs whose speed follows from those before it
  std::vector<int> locked;        ///< places of those among them that cannot turn
  int freedom = 0;                ///< degrees of freedom of the train, before its inputs
  int redundant = 0;              ///< conditions that follow from others: loads are then shared

  bool is_determined() const { return undetermined.empty() && excess.empty(); }
  /// In rad/s.
  double speed(int member, const std::vector<double>& inputs) const;
};

TrainSpeeds speeds_of(const GearTrain& train, const std::vector<int>& inputs);

}  // namespace cognate::train
