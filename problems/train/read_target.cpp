#include "problems/train/read_target.hpp"

#include <fmt/core.h>

#include "problems/train/keys.hpp"

namespace cognate::problems::reading {
namespace {

/// Coaxial trains are searched over three of their four gears.
constexpr int kMostCoaxial = 500;

/// [min, max], both integers from `least` to `most`.
void read_interval(TableReader& table, std::string_view key, const IntegerRule& rule,
                   std::array<int, 2>& interval) {
  const auto range = table.range(key, kNumber);
  if (!range) return;
  const auto is_whole = [](double x) {
    return x == static_cast<double>(static_cast<long long>(x));
  };
  const bool in_range = range->min >= rule.min && range->max <= rule.max;
  if (!in_range || !is_whole(range->min) || !is_whole(range->max)) {
    table.fault(key, fmt::format("is no range of whole numbers from {} to {}; expected [min, max]",
                                 rule.min, rule.max));
    return;
  }
  interval = {static_cast<int>(range->min), static_cast<int>(range->max)};
}

void read_compound(TableReader& target, TableReader& bounds, TrainTarget& problem) {
  for (const std::string_view key : {"input", "output"}) {
    if (target.contains(key) && target.has(key)) {
      target.fault(key, "is given, but is of planetary trains; remove it");
    }
  }
  for (const std::string_view key : {"ring_teeth", "planets"}) {
    if (bounds.contains(key) && bounds.has(key)) {
      bounds.fault(key, "is given, but is of planetary trains; remove it");
    }
  }
  read_interval(bounds, "teeth", {kFewestTrainTeeth, kMostTrainTeeth}, problem.teeth);
  read_interval(bounds, "pairs", {1, kMostPairs}, problem.pairs);
  if (problem.coaxial && problem.pairs[0] > 2) {
    target.fault("coaxial", "is true, but is of two pairs; expected bounds.pairs that hold 2");
  }
  if (problem.coaxial) problem.pairs = {2, 2};
  if (problem.coaxial && problem.teeth[1] - problem.teeth[0] > kMostCoaxial) {
    bounds.fault("teeth", fmt::format("is wider than coaxial trains are searched; expected max - "
                                      "min of at most {}",
                                      kMostCoaxial));
    return;
  }
  const double count = product_count(problem.teeth, problem.pairs[1]);
  if (count > kMostProducts) {
    bounds.fault("teeth", fmt::format("leaves {:.3g} choices of {} gears, and at most {:g} are "
                                      "searched; expected a narrower range or fewer pairs",
                                      count, problem.pairs[1], kMostProducts));
  }
}

void read_planetary(TableReader& target, TableReader& bounds, TrainTarget& problem) {
  if (target.contains("coaxial") && target.has("coaxial")) {
    target.fault("coaxial", "is given, but planetary trains are coaxial; remove it");
  }
  if (bounds.contains("pairs") && bounds.has("pairs")) {
    bounds.fault("pairs", "is given, but is of compound trains; remove it");
  }
  read_interval(bounds, "teeth", {kFewestTrainTeeth, kMostTrainTeeth}, problem.teeth);
  read_interval(bounds, "ring_teeth", {kFewestTrainTeeth, kMostTrainTeeth}, problem.ring_teeth);
  read_interval(bounds, "planets", {1, kMostPlanets}, problem.planets);
  if (problem.input == problem.output) {
    target.fault(target.contains("output") ? "output" : "input",
                 "is input and output at once; expected two different members");
  }
}

}  // namespace

double product_count(const std::array<int, 2>& bounds, int pairs) {
  double count = 1;
  const double different = bounds[1] - bounds[0] + 1;
  for (int k = 0; k < pairs; ++k) count *= (different + k) / (k + 1);
  return count;
}

TrainTarget read_train_target(TableReader& document) {
  TrainTarget problem;
  TableReader target = document.table("target");
  TableReader bounds = document.table("bounds");
  TableReader solve = document.table("solve");
  if (!target.has("ratio")) {
    target.fault("ratio", "is missing; expected input speed over output speed");
  }
  const bool is_planetary = target.contains("train") && target.has_text("train") &&
                            target.choice<TrainType>("train") == TrainType::planetary;
  for (const auto& key : kTrainTargetKeys) {
    const bool is_other =
        is_planetary ? key.name == "coaxial" : key.name == "input" || key.name == "output";
    if (key.name != "train" && !is_other) key.read(target, key, problem);
  }
  problem.train = is_planetary ? TrainType::planetary : TrainType::compound;
  if (!target.has_text("train")) target.choice<TrainType>("train");
  if (is_planetary) {
    for (const auto& key : kTrainTargetKeys) {
      if (key.name == "input" || key.name == "output") key.read(target, key, problem);
    }
    read_planetary(target, bounds, problem);
  } else {
    read_compound(target, bounds, problem);
  }
  problem.designs = solve.integer("designs", 1, kMostTrainDesigns).value_or(problem.designs);
  for (TableReader* table : {&target, &bounds, &solve}) table->finish();
  return problem;
}

}  // namespace cognate::problems::reading
