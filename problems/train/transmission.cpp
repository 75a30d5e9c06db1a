#include "problems/train/transmission.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "problems/toml/nearest.hpp"

namespace cognate::problems {
namespace {

std::size_t place_of(int member) {
  return static_cast<std::size_t>(member);
}

/// The share of the power given at `from` that leaves at `to`, 0 where none does.
double share_passed(const std::optional<train::TrainLoads>& loads,
                    const std::vector<double>& speeds, int from, int to) {
  if (!loads) return 0;
  const double given = loads->external[place_of(from)] * speeds[place_of(from)];
  const double taken = -loads->external[place_of(to)] * speeds[place_of(to)];
  return given > 0 ? std::max(0.0, taken / given) : 0;
}

using Words = std::vector<std::string_view>;

tl::unexpected<TransmissionFault> refused_at(std::string_view key, std::string message) {
  return tl::unexpected(TransmissionFault{key, std::move(message)});
}

std::string unknown_name(const std::string& name, std::string_view what, const Words& known) {
  const auto meant = reading::nearest(name, known);
  return fmt::format("is {}, no {} of the train{}; allowed are {}", reading::in_quotes(name), what,
                     meant ? fmt::format(", perhaps for {}", reading::in_quotes(*meant)) : "",
                     reading::quoted_list(known));
}

/// Members on the fixed axis.
Words shaft_names(const ResolvedTrain& resolved) {
  Words names;
  for (const std::string& name : resolved.names) {
    const int member = resolved.number_of(name);
    if (std::ranges::find(resolved.planets, member, &train::Planet::member) ==
        resolved.planets.end()) {
      names.push_back(name);
    }
  }
  return names;
}

tl::expected<const TrainState*, TransmissionFault> state_named(
    const GearTrainProblem& problem, const std::optional<std::string>& name) {
  Words known;
  for (const TrainState& state : problem.states) known.push_back(state.name);
  if (known.empty() && name) {
    return refused_at("state", "is given, but the train has no [[state]]; remove it");
  }
  if (known.empty()) return nullptr;
  if (!name) {
    return refused_at("state",
                      fmt::format("is missing; expected the state of the gearbox, one of {}",
                                  reading::quoted_list(known)));
  }
  const auto found = std::ranges::find(problem.states, *name, &TrainState::name);
  if (found == problem.states.end())
    return refused_at("state", unknown_name(*name, "state", known));
  return &*found;
}

/// The number of the shaft `name`, or of the train's own, `usual`.
tl::expected<int, TransmissionFault> shaft_named(const ResolvedTrain& resolved,
                                                 std::string_view key,
                                                 const std::optional<std::string>& name,
                                                 int usual) {
  const Words known = shaft_names(resolved);
  if (!name && usual != train::kFrame) return usual;
  if (!name) {
    return refused_at(key,
                      fmt::format("is missing; the train itself does not have one {}: expected "
                                  "one of {}",
                                  key, reading::quoted_list(known)));
  }
  if (std::ranges::find(known, *name) == known.end()) {
    return refused_at(key, unknown_name(*name, "shaft", known));
  }
  return resolved.number_of(*name);
}

/// The speeds of all members for that of one, or why they do not follow from it.
tl::expected<train::TrainSpeeds, TransmissionFault> speeds_from(const ResolvedTrain& resolved,
                                                                int input) {
  train::TrainSpeeds speeds = train::speeds_of(resolved.train, {input});
  const std::string name = reading::in_quotes(resolved.names[place_of(input)]);
  if (!speeds.excess.empty()) {
    return refused_at("input", fmt::format("is {}, which meshes and fixed members lock; expected a "
                                           "shaft that turns",
                                           name));
  }
  if (speeds.freedom != 1 || !speeds.undetermined.empty()) {
    return refused_at("train",
                      fmt::format("has {} degrees of freedom; expected 1, so that its input "
                                  "{} determines the speed of every shaft",
                                  speeds.freedom, name));
  }
  if (speeds.redundant > 0) {
    return refused_at("train",
                      "has meshes, fixed members or engaged parts that share a load, so that its "
                      "torques are not determined; expected one path of the power");
  }
  return speeds;
}

std::vector<double> speeds_in_rad(const ResolvedTrain& resolved, const train::TrainSpeeds& speeds) {
  std::vector<double> all;
  for (int i = 0; i < resolved.train.members; ++i) all.push_back(speeds.speed(i, {1.0}));
  return all;
}

tl::expected<Transmission, TransmissionFault> between(const GearTrainProblem& problem,
                                                      const ResolvedTrain& resolved, int input,
                                                      int output) {
  const std::string name = reading::in_quotes(resolved.names[place_of(output)]);
  if (input == output) {
    return refused_at("output", fmt::format("is {}, the input too; expected another shaft", name));
  }
  const auto speeds = speeds_from(resolved, input);
  if (!speeds) return tl::unexpected(speeds.error());
  const train::Fraction share = speeds->shares[place_of(output)][0];
  if (share.is_zero()) {
    return refused_at("output",
                      fmt::format("is {}, which stands still; expected a shaft that turns", name));
  }
  const auto in_rad = speeds_in_rad(resolved, *speeds);
  const UnitLoads loads = unit_loads(resolved.train, in_rad, input, output);
  if (!(loads.efficiency > 0)) {
    return refused_at("train",
                      fmt::format("is self-locking: driven at {} it cannot move {} against a "
                                  "load; expected one that passes power on",
                                  reading::in_quotes(resolved.names[place_of(input)]), name));
  }
  const double speed = in_rad[place_of(output)];
  return Transmission{
      .ratio = 1 / share,
      .efficiency = loads.efficiency,
      .reverse_efficiency = loads.reverse_efficiency,
      .output_inertia = doubled_energy(problem, resolved, in_rad) / (speed * speed)};
}

}  // namespace

UnitLoads unit_loads(const train::GearTrain& train, const std::vector<double>& speeds, int input,
                     int output) {
  const double sense = std::copysign(1.0, speeds[place_of(input)]);
  UnitLoads unit{.forward = loads_of(train, speeds, {{input, sense}}, {output})};
  unit.efficiency = share_passed(unit.forward, speeds, input, output);
  const auto reverse = loads_of(train, speeds, {{input, -sense}}, {output});
  unit.reverse_efficiency = share_passed(reverse, speeds, output, input);
  return unit;
}

double doubled_energy(const GearTrainProblem& problem, const ResolvedTrain& resolved,
                      const std::vector<double>& speeds) {
  double sum = 0;
  for (const auto& shaft : problem.shafts) {
    const double own = speeds[place_of(resolved.number_of(shaft.name))];
    sum += shaft.inertia * own * own;
  }
  for (std::size_t k = 0; k < resolved.planets.size(); ++k) {
    const train::Planet& planet = resolved.planets[k];
    const auto radii = orbit_radii(planet, resolved.sized, resolved.planets);
    const double radius = radii.empty() ? 0 : radii.front() * metres(problem.length_unit);
    const double own = speeds[place_of(planet.member)];
    const double along = speeds[place_of(planet.carrier)] * radius;
    sum += planet.count *
           (problem.planets[k].inertia * own * own + problem.planets[k].mass * along * along);
  }
  return sum;
}

tl::expected<Transmission, TransmissionFault> transmission(const GearTrainProblem& problem,
                                                           const TransmissionShafts& shafts) {
  if (problem.target) {
    return refused_at(
        "train",
        "has [target], a train to be found; expected one that is given by its [[mesh]] "
        "tables");
  }
  const auto state = state_named(problem, shafts.state);
  if (!state) return tl::unexpected(state.error());
  const ResolvedTrain own = resolved(problem, *state);
  const int only = own.inputs.size() == 1 ? own.inputs.front() : train::kFrame;
  const auto input = shaft_named(own, "input", shafts.input, only);
  if (!input) return tl::unexpected(input.error());
  const auto output = shaft_named(own, "output", shafts.output, own.output);
  if (!output) return tl::unexpected(output.error());
  return between(problem, own, *input, *output);
}

}  // namespace cognate::problems
