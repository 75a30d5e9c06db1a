#include "tests/stress/layers_cases.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "analysis/mechanism/assembly_ranges.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/layers/assign.hpp"
#include "tests/stress/layers_brute.hpp"

namespace cognate::test {
namespace {

double uniform(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

Vec2d any_point(std::mt19937& random, double size) {
  return {uniform(random, -size, size), uniform(random, -size, size)};
}

/// Crank and two RRR dyads; the second on a point of a body of the first, and on the frame
/// (Stephenson III, Watt II) or on the other body (Watt I) or on the crank.
Mechanism<double> six_bar(std::mt19937& random) {
  Mechanism<double> mechanism;
  mechanism.drive = Crank<double>{{0, 0}, uniform(random, 0.5, 1.5)};
  const double length = std::get<Crank<double>>(mechanism.drive).length;
  mechanism.dyads.emplace_back(Rrr<double>{{1, {length, 0}},
                                           {0, any_point(random, 4)},
                                           uniform(random, 1.5, 5),
                                           uniform(random, 1.5, 5),
                                           random() % 2 ? Assembly::open : Assembly::crossed});
  const int from = random() % 2 ? 2 : 3;
  const int to = static_cast<int>(random() % 3) == 0 ? 5 - from : random() % 4 == 0 ? 1 : 0;
  mechanism.dyads.emplace_back(Rrr<double>{{from, any_point(random, 3)},
                                           {to, any_point(random, to == 1 ? 1.5 : 5)},
                                           uniform(random, 1.5, 6),
                                           uniform(random, 1.5, 6),
                                           random() % 2 ? Assembly::open : Assembly::crossed});
  return mechanism;
}

}  // namespace

LayerCase random_six_bar(std::mt19937& random) {
  for (;;) {
    LayerCase made;
    made.mechanism.mechanism = six_bar(random);
    const AssemblyRanges motion = follow(made.mechanism.mechanism, 0, kTurn);
    if (motion.runs.size() != 1 || !motion.runs.front().changes.empty()) continue;
    made.from = motion.runs.front().from;
    made.to = motion.runs.front().to;
    if (made.to - made.from < 0.5) continue;
    made.mechanism.bodies = {"frame", "crank", "coupler", "rocker", "rod", "output"};
    if (random() % 3 == 0) made.mechanism.points.push_back({"P", {4, any_point(random, 2)}});
    made.sizes.link_width = uniform(random, 0.1, 0.6);
    made.sizes.pin_diameter = uniform(random, 0.2, 1) * made.sizes.link_width;
    made.sizes.clearance = random() % 2 ? uniform(random, 0, 0.1) : 0;
    if (random() % 3 == 0) {
      made.sizes.widths = {{"coupler", uniform(random, 1, 2) * made.sizes.link_width}};
    }
    return made;
  }
}

std::string fault_of_layers(const LayerCase& given, int samples, bool enumerate,
                            LayerCounts& counts) {
  const auto& mechanism = given.mechanism;
  const AssemblyRanges motion = follow(mechanism.mechanism, 0, kTurn);
  const auto layers = problems::assign_layers(mechanism, motion, given.sizes);
  if (!layers) return layers.error();
  const BruteLayers brute(mechanism, given.sizes, given.from, given.to, samples);
  ++(layers->count ? counts.assigned : counts.impossible);
  for (const auto& conflict : layers->conflicts) {
    if (conflict.kind == problems::LayerConflictKind::unresolved) ++counts.unresolved;
    if (!brute.confirms(conflict, 1e-5)) {
      return fmt::format("{} and {} do not first collide at {}", conflict.first, conflict.second,
                         *conflict.drive);
    }
  }
  if (layers->count) {
    const double interference = brute.interference(*layers);
    counts.greatest_interference = std::max(counts.greatest_interference, interference);
    if (interference >= 0) return fmt::format("parts overlap by {}", interference);
  }
  if (!enumerate) return {};
  const auto fewest = brute.fewest();
  if (fewest == layers->count) return {};
  const auto text = [](const std::optional<int>& count) {
    return count ? fmt::format("{}", *count) : std::string("none");
  };
  return fmt::format("{} layers, where brute force finds {}", text(layers->count), text(fewest));
}

}  // namespace cognate::test
