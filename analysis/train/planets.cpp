#include "analysis/train/planets.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/constants.hpp"

namespace cognate::train {
namespace {

const Planet* planet_of(int member, const std::vector<Planet>& planets) {
  const auto found = std::ranges::find(planets, member, &Planet::member);
  return found == planets.end() ? nullptr : &*found;
}

/// Which gear of the mesh is central; −1 where both or none are planets.
int central_side(const Mesh& mesh, const std::vector<Planet>& planets) {
  const bool first = planet_of(mesh.gears[0], planets), second = planet_of(mesh.gears[1], planets);
  return first == second ? -1 : first ? 1 : 0;
}

bool has_internal_teeth(const Mesh& mesh, std::size_t side) {
  return mesh.sense > 0 && mesh.teeth[side] > mesh.teeth[1 - side];
}

/// Follows the planets from one central mesh to all others that they lead to.
class AssemblyPaths {
 public:
  AssemblyPaths(const std::vector<SizedMesh>& meshes, const std::vector<Planet>& planets,
                std::vector<Assembly>& found)
      : meshes_(meshes), planets_(planets), found_(found) {}

  void follow_from(std::size_t start) {
    start_ = start;
    const Mesh& mesh = meshes_[start].mesh;
    const int central = central_side(mesh, planets_);
    const auto side = static_cast<std::size_t>(1 - central);
    visited_.assign(planets_.size(), false);
    first_ = Fraction(mesh.teeth[static_cast<std::size_t>(central)]);
    step(mesh.gears[side], start, Fraction(mesh.sense) * first_, Fraction(mesh.teeth[side]),
         Fraction(1));
  }

 private:
  /// `member` is turned at `entry` by `turn` teeth for each turn of the carrier, its gear there has
  /// `teeth`; `measure`: of what tooth by tooth it can be turned, in teeth of that gear.
  void step(int member, std::size_t entry, const Fraction& turn, const Fraction& teeth,
            const Fraction& measure) {
    const Planet* planet = planet_of(member, planets_);
    const auto place = static_cast<std::size_t>(planet - planets_.data());
    if (visited_[place]) return;
    visited_[place] = true;
    for (std::size_t k = 0; k < meshes_.size(); ++k) {
      if (k == entry) continue;
      const Mesh& mesh = meshes_[k].mesh;
      for (const std::size_t side : {0U, 1U}) {
        if (mesh.gears[side] != member) continue;
        const Fraction own(mesh.teeth[side]);
        const Fraction out = Fraction(mesh.sense) * turn * own / teeth;
        const Fraction steps = common_measure(Fraction(1), measure * own / teeth);
        const int other = mesh.gears[1 - side];
        if (planet_of(other, planets_)) {
          step(other, k, out, Fraction(mesh.teeth[1 - side]), steps);
        } else if (k > start_) {
          add(k, static_cast<int>(place), planet->count, Fraction(mesh.teeth[1 - side]) - out,
              steps);
        }
      }
    }
  }

  void add(std::size_t end, int planet, int count, const Fraction& teeth, const Fraction& steps) {
    const Fraction share = teeth / (Fraction(count) * steps);
    found_.push_back({planet, {static_cast<int>(start_), static_cast<int>(end)}, is_whole(share)});
  }

  const std::vector<SizedMesh>& meshes_;
  const std::vector<Planet>& planets_;
  std::vector<Assembly>& found_;
  std::vector<bool> visited_;
  std::size_t start_ = 0;
  Fraction first_;
};

}  // namespace

double centre_distance(const SizedMesh& mesh) {
  return 0.5 * mesh.module * std::abs(mesh.mesh.teeth[0] - mesh.mesh.signed_teeth());
}

std::vector<double> orbit_radii(const Planet& planet, const std::vector<SizedMesh>& meshes,
                                const std::vector<Planet>& planets) {
  std::vector<double> radii;
  for (const SizedMesh& sized : meshes) {
    const bool is_own =
        std::ranges::find(sized.mesh.gears, planet.member) != sized.mesh.gears.end();
    if (!is_own || sized.is_bevel || central_side(sized.mesh, planets) < 0) continue;
    radii.push_back(centre_distance(sized));
  }
  return radii;
}

std::optional<double> neighbour_clearance(const Planet& planet,
                                          const std::vector<SizedMesh>& meshes,
                                          const std::vector<Planet>& planets) {
  const auto radii = orbit_radii(planet, meshes, planets);
  if (planet.count < 2 || radii.empty()) return std::nullopt;
  const double apart = 2 * std::ranges::min(radii) * std::sin(kPi / planet.count);
  std::optional<double> least;
  for (const SizedMesh& sized : meshes) {
    for (const std::size_t side : {0U, 1U}) {
      const bool is_own = sized.mesh.gears[side] == planet.member;
      if (!is_own || sized.is_bevel || has_internal_teeth(sized.mesh, side)) continue;
      const double clearance = apart - sized.module * (sized.mesh.teeth[side] + 2);
      if (!least || clearance < *least) least = clearance;
    }
  }
  return least;
}

std::vector<Assembly> assemblies(const std::vector<SizedMesh>& meshes,
                                 const std::vector<Planet>& planets) {
  std::vector<Assembly> found;
  AssemblyPaths paths(meshes, planets, found);
  for (std::size_t k = 0; k < meshes.size(); ++k) {
    if (central_side(meshes[k].mesh, planets) >= 0) paths.follow_from(k);
  }
  return found;
}

}  // namespace cognate::train
