#include "problems/train/search.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "analysis/numbers/constants.hpp"
#include "problems/train/analyse.hpp"
#include "problems/train/tooth_products.hpp"

namespace cognate::problems {
namespace {

/// Teeth of a train on fixed axes, or of a planetary one.
struct TrainDesign {
  std::vector<std::array<int, 2>> stages;  ///< driver and driven of each pair
  int sun = 0, planet = 0, ring = 0, count = 0;
  double error = 0;
  int size = 0;
};

/// The best designs, best first, no more than requested.
class BestTrains {
 public:
  BestTrains(TrainObjective objective, std::size_t count) : objective_(objective), count_(count) {}

  bool may_take(double error, int size) const {
    return best_.size() < count_ || key(error, size) < key(best_.back().error, best_.back().size);
  }
  void take(TrainDesign found) {
    if (!may_take(found.error, found.size)) return;
    const auto place = std::ranges::upper_bound(best_, found, [&](const auto& a, const auto& b) {
      return key(a.error, a.size) < key(b.error, b.size);
    });
    best_.insert(place, std::move(found));
    if (best_.size() > count_) best_.pop_back();
  }
  const std::vector<TrainDesign>& all() const { return best_; }

 private:
  std::pair<double, double> key(double error, int size) const {
    return objective_ == TrainObjective::size ? std::pair(double(size), error)
                                              : std::pair(error, double(size));
  }

  TrainObjective objective_;
  std::size_t count_;
  std::vector<TrainDesign> best_;
};

class TrainSearch {
 public:
  TrainSearch(const TrainTarget& target, double tolerance, std::size_t count,
              const Deadline& deadline)
      : target_(target),
        tolerance_(tolerance),
        count_(count),
        deadline_(deadline),
        best_(target.objective, count) {}

  std::vector<TrainDesign> found() && {
    if (target_.train == TrainType::planetary) {
      find_planetary();
    } else if (target_.coaxial) {
      find_coaxial();
    } else {
      find_compound();
    }
    return best_.all();
  }

 private:
  void find_compound() {
    const QuotientSearch search{.ratio = std::abs(target_.ratio),
                                .tolerance = tolerance_,
                                .by_size = target_.objective == TrainObjective::size,
                                .count = count_,
                                .is_over = [&] { return deadline_.reached(); }};
    std::vector<ToothQuotient> best;
    for (int pairs = target_.pairs[0]; pairs <= target_.pairs[1]; ++pairs) {
      add_quotients(tooth_products(target_.teeth, pairs), pairs, search, best);
    }
    for (const ToothQuotient& quotient : best) {
      const auto drivers = teeth_of(quotient.driver, target_.teeth, quotient.pairs);
      const auto driven = teeth_of(quotient.driven, target_.teeth, quotient.pairs);
      TrainDesign found{.error = quotient.error, .size = quotient.size()};
      for (std::size_t k = 0; k < drivers.size(); ++k) {
        found.stages.push_back({drivers[k], driven[k]});
      }
      best_.take(std::move(found));
    }
  }

  /// The relative error of the ratio; nothing where it is beyond the tolerance.
  std::optional<double> error_of(int driven, int driver, double wanted) const {
    const double error =
        ratio_error(static_cast<std::uint64_t>(driven), static_cast<std::uint64_t>(driver), wanted);
    return error > tolerance_ + kExactRatio ? std::nullopt : std::optional(error);
  }

  /// z₁ + w₁ = z₂ + w₂, so that w₁w₂ grows with w₁: of each pair of drivers those nearest to the
  /// ratio are walked outwards.
  void find_coaxial() {
    const auto [least, most] = target_.teeth;
    const double wanted = std::abs(target_.ratio);
    for (int first = least; first <= most && !deadline_.reached(); ++first) {
      for (int second = first; second <= most; ++second) {
        const double half = 0.5 * (second - first);
        const double root = half + std::sqrt(half * half + wanted * first * second);
        const double start = std::clamp(std::floor(root), double(least), double(most));
        for (int w = static_cast<int>(start); w >= least && take_coaxial(first, second, w); --w) {
        }
        for (int w = static_cast<int>(start) + 1; w <= most && take_coaxial(first, second, w);
             ++w) {
        }
      }
    }
  }

  /// False where those farther from the ratio cannot be among the best.
  bool take_coaxial(int first, int second, int driven) {
    const int other = first + driven - second;
    const auto [least, most] = target_.teeth;
    if (other < least || other > most) return true;
    const auto error = error_of(driven * other, first * second, std::abs(target_.ratio));
    const bool by_error = target_.objective == TrainObjective::error;
    if (!error || (by_error && !best_.may_take(*error, 0))) return false;
    const int size = 2 * (first + driven);
    if (best_.may_take(*error, size)) {
      best_.take({.stages = {{first, driven}, {second, other}}, .error = *error, .size = size});
    }
    return true;
  }

  /// Of ω_in/ω_out of sun, ring and carrier: a ω of all add up to 0.
  std::optional<double> planetary_error(int sun, int ring) const {
    const auto coefficient = [&](PlanetaryMember member) {
      switch (member) {
        case PlanetaryMember::sun:
          return sun;
        case PlanetaryMember::ring:
          return ring;
        case PlanetaryMember::carrier:
          return -(sun + ring);
      }
      return 0;
    };
    const int output = coefficient(target_.output), input = coefficient(target_.input);
    const int sense = (output < 0) == (input < 0) ? -1 : 1;
    return error_of(std::abs(output), std::abs(input), sense * target_.ratio);
  }

  /// The greatest number of planets that fit; 0 where none does.
  int planets_that_fit(int sun, int planet, int ring) const {
    for (int count = target_.planets[1]; count >= target_.planets[0]; --count) {
      const bool beside = count == 1 || (sun + planet) * std::sin(kPi / count) > planet + 2 + 1e-9;
      if (beside && (sun + ring) % count == 0) return count;
    }
    return 0;
  }

  void find_planetary() {
    const auto [least, most] = target_.teeth;
    const auto [fewest_ring, most_ring] = target_.ring_teeth;
    for (int sun = least; sun <= most && !deadline_.reached(); ++sun) {
      for (int planet = least; planet <= most; ++planet) {
        const int ring = sun + 2 * planet;
        if (ring > most_ring) break;
        if (ring < fewest_ring) continue;
        const auto error = planetary_error(sun, ring);
        if (!error || !best_.may_take(*error, 2 * ring)) continue;
        const int count = planets_that_fit(sun, planet, ring);
        if (count == 0) continue;
        best_.take({.sun = sun,
                    .planet = planet,
                    .ring = ring,
                    .count = count,
                    .error = *error,
                    .size = 2 * ring});
      }
    }
  }

  const TrainTarget& target_;
  double tolerance_;
  std::size_t count_;
  const Deadline& deadline_;
  BestTrains best_;
};

GearTrainProblem compound_train(const TrainDesign& found) {
  GearTrainProblem train;
  const auto shaft = [](std::size_t k) { return fmt::format("shaft {}", k + 1); };
  for (std::size_t k = 0; k < found.stages.size(); ++k) {
    train.meshes.push_back({.gears = {shaft(k), shaft(k + 1)}, .teeth = found.stages[k]});
  }
  train.inputs = {{.member = shaft(0)}};
  train.output = TrainOutput{.member = shaft(found.stages.size())};
  return train;
}

GearTrainProblem planetary_train(const TrainDesign& found, const TrainTarget& target) {
  GearTrainProblem train;
  train.meshes = {{.gears = {"sun", "planet"}, .teeth = {found.sun, found.planet}},
                  {.gears = {"planet", "ring"},
                   .teeth = {found.planet, found.ring},
                   .type = MeshType::internal}};
  train.planets = {{.name = "planet", .carrier = "carrier", .count = found.count}};
  for (const auto& [name, member] : names<PlanetaryMember>()) {
    if (member == target.input) {
      train.inputs = {{.member = std::string(name)}};
    } else if (member == target.output) {
      train.output = TrainOutput{.member = std::string(name)};
    } else {
      train.fixed = {std::string(name)};
    }
  }
  return train;
}

GearTrainDesign design_of(const TrainDesign& found, const GearTrainProblem& problem) {
  const TrainTarget& target = *problem.target;
  GearTrainProblem train =
      target.train == TrainType::planetary ? planetary_train(found, target) : compound_train(found);
  train.title = problem.title;
  train.length_unit = problem.length_unit;
  GearTrainDesign design = analysed_train(train, nullptr, "search");
  design.metrics.push_back({"ratio_error", found.error});
  design.constraints.insert(
      design.constraints.begin(),
      {"target.ratio_tolerance", found.error, target.ratio_tolerance,
       found.error <= target.ratio_tolerance + kExactRatio, std::nullopt, BoundSide::most});
  return design;
}

}  // namespace

void find_trains(const GearTrainProblem& problem, const Deadline& deadline,
                 GearTrainResult& result) {
  const TrainTarget& target = *problem.target;
  auto found = TrainSearch(target, target.ratio_tolerance, static_cast<std::size_t>(target.designs),
                           deadline)
                   .found();
  if (found.empty() && !deadline.reached()) {
    TrainTarget nearest = target;
    nearest.objective = TrainObjective::error;
    found = TrainSearch(nearest, kInfinity, 1, deadline).found();
    if (found.empty()) {
      result.notes.push_back(
          "No train of these numbers of teeth and planets fits together; expected wider bounds.");
    } else {
      result.notes.push_back(fmt::format(
          "No train of these numbers of teeth has the ratio within the tolerance; the nearest "
          "misses it by {:.3g} of {:g}.",
          found.front().error, target.ratio));
    }
  }
  for (const TrainDesign& each : found) result.designs.push_back(design_of(each, problem));
}

}  // namespace cognate::problems
