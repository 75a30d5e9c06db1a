// Alt's problem by the hundred: how many solutions are found for points of several kinds, and how
// often a planted linkage is among them. A command of its own, as it takes minutes:
//
//     nine_point_stress [sets of each kind, 15 if not given]
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "synthesis/exact/nine_point/follow.hpp"
#include "synthesis/exact/nine_point/nine_point.hpp"
#include "synthesis/exact/nine_point/start_cache.hpp"

namespace cognate::synthesis {
namespace {

using Complex = std::complex<double>;

/// Sums over the sets of one kind.
struct Tally {
  int sets = 0, complete = 0, recovered = 0, planted = 0;
  int missing = 0, at_infinity = 0, repeated = 0, least_real = 1442, most_real = 0;
  double residual = 0, condition = 0;

  void add(const ExactPathSolutions& found) {
    ++sets;
    complete += found.finite == found.tracked;
    missing += found.tracked - found.finite - found.at_infinity;
    at_infinity += found.at_infinity;
    repeated += found.repeated;
    int real = 0;
    for (const PathRoot& root : found.roots) {
      if (!root.real) continue;
      ++real;
      residual = std::max(residual, root.residual);
      condition = std::max(condition, root.condition);
    }
    least_real = std::min(least_real, real);
    most_real = std::max(most_real, real);
  }
};

void print(const std::string& kind, const Tally& tally) {
  fmt::print(
      "{:34} {:4} sets, all 1442 in {:4}; {:3} paths lost, {:3} at infinity, {:5} repeated; ", kind,
      tally.sets, tally.complete, tally.missing, tally.at_infinity, tally.repeated);
  fmt::print("real {}-{}, residual {:.1e}, condition {:.1e}", tally.least_real, tally.most_real,
             tally.residual, tally.condition);
  if (tally.planted > 0) fmt::print("; planted back in {} of {}", tally.recovered, tally.planted);
  fmt::print("\n");
}

/// A crank-rocker, and its coupler point at nine crank angles.
struct Planted {
  Complex pivots[2];
  std::vector<PathPose> points;
};

Planted plant(std::mt19937_64& random, double arc) {
  std::uniform_real_distribution<double> near(-0.3, 0.3), any(0, kTurn);
  const double crank = 0.5 + 0.3 * near(random), coupler = 2 + near(random);
  const double rocker = 1.6 + near(random), frame = 1.9 + near(random), start = any(random);
  const Complex traced(1 + near(random), 0.8 + near(random));
  Planted planted{{0, frame}, {}};
  const bool whole = arc > 6;
  for (int j = 0; j < 9; ++j) {
    const Complex b = std::polar(crank, start + arc * j / (whole ? 9 : 8));
    const double distance = std::abs(frame - b);
    const double cosine =
        (coupler * coupler + distance * distance - rocker * rocker) / (2 * coupler * distance);
    const Complex at = b + traced * std::polar(1.0, std::arg(frame - b) + std::acos(cosine));
    planted.points.push_back({{at.real(), at.imag()}, {}});
  }
  return planted;
}

/// Whether the fixed pivots planted are two of the three foci of a real solution.
bool comes_back(const ExactPathSolutions& found, const Planted& planted) {
  for (const PathRoot& root : found.roots) {
    if (!root.real) continue;
    const auto triplet = cognates(found.system, root);
    const double tolerance = 1e-12 + 1e-13 * root.condition;
    const auto is_focus = [&](const Complex& pivot) {
      return std::any_of(triplet.begin(), triplet.end(), [&](const PathRoot& one) {
        const Vec2d at = to_plane(found.system, one.first.fixed);
        return std::abs(Complex(at.x, at.y) - pivot) < tolerance;
      });
    };
    if (is_focus(planted.pivots[0]) && is_focus(planted.pivots[1])) return true;
  }
  return false;
}

void random_complex(int sets) {
  using namespace nine_point;
  StopToken stop({});
  TrackingOptions means;
  means.stop = &stop;
  const auto start = start_set({1, 8}, {}, means);
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  Tally tally;
  for (int set = 0; set < sets; ++set) {
    PathParameters data{{1, 8}, {}, {}, {}};
    for (int j = 0; j < 8; ++j) {
      data.d.emplace_back(normal(random), normal(random));
      data.d_bar.emplace_back(normal(random), normal(random));
    }
    const FollowedPaths paths = follow(*start, data, means);
    ExactPathSolutions found;
    found.tracked = start->count();
    found.finite = static_cast<int>(paths.roots.size()) / unknowns(8);
    found.at_infinity = paths.at_infinity;
    found.repeated = paths.repeated;
    tally.add(found);
  }
  print("random complex points", tally);
}

void random_real(int sets) {
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  Tally tally;
  for (int set = 0; set < sets; ++set) {
    std::vector<PathPose> points;
    for (int j = 0; j < 9; ++j) points.push_back({{normal(random), normal(random)}, {}});
    tally.add(solve_exact_path(points));
  }
  print("random real points", tally);
}

void planted_curves(int sets, double arc) {
  std::mt19937_64 random(3);
  Tally tally;
  for (int set = 0; set < sets; ++set) {
    const Planted planted = plant(random, arc);
    const ExactPathSolutions found = solve_exact_path(planted.points);
    tally.add(found);
    ++tally.planted;
    tally.recovered += comes_back(found, planted);
  }
  print(fmt::format("crank-rocker, crank turns by {:.1f}", arc), tally);
}

}  // namespace
}  // namespace cognate::synthesis

int main(int count, char** arguments) {
  using namespace cognate::synthesis;
  const int sets = count > 1 ? std::max(1, std::atoi(arguments[1])) : 15;
  random_complex(sets);
  random_real(sets);
  for (const double arc : {kTurn, 3.0, 2.0, 1.0, 0.5}) planted_curves(sets, arc);
}
