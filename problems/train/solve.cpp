/// Gear trains from problem to designs.
#include "problems/linkage/verify.hpp"
#include "problems/train/analyse.hpp"
#include "problems/train/resolve.hpp"
#include "problems/train/result.hpp"
#include "problems/train/search.hpp"

namespace cognate::problems {
namespace {

void take_notes(GearTrainResult& result) {
  for (const auto& design : result.designs) {
    result.notes.insert(result.notes.end(), design.notes.begin(), design.notes.end());
    for (const auto& warning : design.warnings) {
      if (std::ranges::find(result.warnings, warning) == result.warnings.end()) {
        result.warnings.push_back(warning);
      }
    }
    for (const auto& check : design.constraints) {
      if (check.satisfied || !check.name.starts_with("planet_assembly.")) continue;
      std::string note = "Planets \"" + check.name.substr(check.name.find('.') + 1) +
                         "\" equally spaced do not fit between their central gears: expected "
                         "teeth, or a count, for which they do.";
      if (std::ranges::find(result.notes, note) == result.notes.end()) {
        result.notes.push_back(std::move(note));
      }
    }
  }
}

bool is_sound(const GearTrainDesign& design) {
  const auto is_locked = [](const Quantity& quantity) {
    const bool* value = std::get_if<bool>(&quantity.value);
    return quantity.name == "self_locking" && value && *value;
  };
  return all_satisfied(design.constraints) && std::ranges::none_of(design.metrics, is_locked);
}

}  // namespace

GearTrainResult solve(const GearTrainProblem& given, const Run& run) {
  const auto valid = KindTraits<GearTrainProblem>::checked(given);
  if (!valid) return refused<GearTrainResult>(valid.error());
  const Deadline deadline(run);
  GearTrainResult result;
  if (given.target) {
    find_trains(given, deadline, result);
  } else {
    for (const TrainState* state : states_of(given)) {
      result.designs.push_back(analysed_train(given, state, "given"));
    }
    result.work.skipped = {"search"};
  }
  if (deadline.interrupted() || deadline.expired()) {
    result.status = deadline.interrupted() ? Status::interrupted : Status::time_limit;
  } else if (!result.designs.empty()) {
    const bool all = std::ranges::all_of(result.designs, is_sound);
    result.status = all ? Status::solved : Status::infeasible;
  }
  take_notes(result);
  result.work.seconds = deadline.spent();
  return result;
}

}  // namespace cognate::problems
