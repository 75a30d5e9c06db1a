/// @file Whether the planets of a gear train fit: between their central gears, beside one another,
/// on one radius.
#pragma once

#include <optional>
#include <vector>

#include "analysis/train/gear_train.hpp"

namespace cognate::train {

/// So many equal ones about the axis of `carrier`, equally spaced.
struct Planet {
  int member = 0;
  int carrier = 0;
  int count = 1;
};

/// A mesh with its size; bevel gears have none here.
struct SizedMesh {
  Mesh mesh;
  double module = 1;
  bool is_bevel = false;
};

/// Distance of the axes: m (z_a + z_b)/2, of internal teeth m |z_a − z_b|/2.
double centre_distance(const SizedMesh& mesh);

/// Radii of the orbit of `planet` that its meshes with central gears need at zero sum of shifts:
/// all the same, or profile shifts or unequal modules are needed.
std::vector<double> orbit_radii(const Planet& planet, const std::vector<SizedMesh>& meshes,
                                const std::vector<Planet>& planets);

/// The least distance between tips of neighbours of standard addendum, 2 r sin(π/N) − m (z + 2);
/// empty of a single planet, or where no orbit or external gear is known.
std::optional<double> neighbour_clearance(const Planet& planet,
                                          const std::vector<SizedMesh>& meshes,
                                          const std::vector<Planet>& planets);

/// Two meshes with central gears that planets connect.
struct Assembly {
  int planet = 0;               ///< place of a planet between them
  std::array<int, 2> meshes{};  ///< places of both
  bool fits = false;            ///< equally spaced planets can be put in
};

/// Of planets of `count` teeth z₁ … between central gears of z_a and z_b: equally spaced ones fit
/// where (z_b − S z_a ∏ z_out/z_in)/N, S the product of the senses, is a whole multiple of the
/// common measure of 1 and every ∏ z_out/z_in from a planet on. Of one planet of one gear that is
/// the textbooks' (z_sun + z_ring)/N.
std::vector<Assembly> assemblies(const std::vector<SizedMesh>& meshes,
                                 const std::vector<Planet>& planets);

}  // namespace cognate::train
