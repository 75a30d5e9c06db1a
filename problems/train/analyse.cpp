#include "problems/train/analyse.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "analysis/numbers/constants.hpp"
#include "analysis/train/train_loads.hpp"
#include "problems/train/resolve.hpp"
#include "problems/train/transmission.hpp"

namespace cognate::problems {
namespace {

using train::KnownTorque;
using train::TrainLoads;

/// Orbits that differ by less share one radius.
constexpr double kSameRadius = 1e-9;

/// "-72/35", "4"; empty of what is longer than anyone reads.
std::string text_of(const train::Fraction& fraction) {
  constexpr std::size_t kLongest = 40;
  std::string text = fraction.str();
  return text.size() > kLongest ? std::string{} : text;
}

double sign_of(double x) {
  return x < 0 ? -1 : 1;
}

class TrainAnalysis {
 public:
  TrainAnalysis(const GearTrainProblem& problem, const TrainState* state, const std::string& origin)
      : problem_(problem),
        own_(resolved(problem, state)),
        speeds_(speeds_of(own_.train, own_.inputs)) {
    design_.settled = problem;
    design_.origin = origin;
    if (state) design_.state = state->name;
    for (const auto& input : problem.inputs) input_speeds_.push_back(input.speed);
    for (int i = 0; i < own_.train.members; ++i) {
      member_speeds_.push_back(speeds_.speed(i, input_speeds_));
    }
  }

  GearTrainDesign made() && {
    add_members();
    add_ratio();
    add_unit_loads();
    add_loads();
    add_inertia();
    add_planets();
    return std::move(design_);
  }

 private:
  template <class Value>
  void add(const char* name, Value value) {
    design_.metrics.push_back({name, value});
  }

  static std::size_t at(int member) { return static_cast<std::size_t>(member); }
  double speed(int member) const { return member_speeds_[at(member)]; }
  bool has_output() const { return own_.output != train::kFrame; }

  std::string role_of(int member) const {
    for (const auto& planet : own_.planets) {
      if (planet.member == member) return "planet";
      if (planet.carrier == member) return "carrier";
    }
    return "shaft";
  }

  void add_members() {
    for (int i = 0; i < own_.train.members; ++i) {
      TrainMember member{.name = own_.names[at(i)], .role = role_of(i)};
      if (own_.inputs.size() == 1) member.speed_exact = text_of(speeds_.shares[at(i)][0]);
      member.speed = speed(i);
      design_.members.push_back(std::move(member));
    }
    for (const auto& planet : own_.planets) {
      design_.members[at(planet.member)].relative_speed =
          speed(planet.member) - speed(planet.carrier);
    }
  }

  void add_ratio() {
    if (!design_.state.empty()) add("state", design_.state);
    add("degrees_of_freedom", double(speeds_.freedom));
    if (has_output()) add("output_speed_rad_s", speed(own_.output));
    if (has_output() && own_.inputs.size() == 1) {
      const train::Fraction share = speeds_.shares[at(own_.output)][0];
      if (share.is_zero()) {
        note(fmt::format("The output \"{}\" stands still.", own_.names[at(own_.output)]));
      } else {
        const train::Fraction ratio = 1 / share;
        add("ratio", ratio.convert_to<double>());
        if (auto exact = text_of(ratio); !exact.empty()) add("ratio_exact", std::move(exact));
      }
    }
    add_sizes();
  }

  void note(const std::string& sentence) {
    design_.notes.push_back(design_.state.empty()
                                ? sentence
                                : fmt::format("In state \"{}\": {}", design_.state, sentence));
  }

  void add_sizes() {
    int sum = 0, most = 0;
    for (const auto& mesh : problem_.meshes) {
      for (const int teeth : mesh.teeth) {
        sum += teeth;
        most = std::max(most, teeth);
      }
    }
    add("teeth_sum", double(sum));
    add("teeth_max", double(most));
  }

  std::optional<TrainLoads> loads(const std::vector<KnownTorque>& known,
                                  const std::vector<int>& unknown) const {
    return loads_of(own_.train, member_speeds_, known, unknown);
  }

  /// Efficiency in both senses of the power, of one input and one output.
  void add_unit_loads() {
    const bool is_simple = has_output() && own_.inputs.size() == 1 && speeds_.redundant == 0;
    if (speeds_.redundant > 0) {
      note(fmt::format(
          "Torques are not determined: meshes, fixed members and engaged parts give {} more "
          "conditions than the speeds need, and share the load.",
          speeds_.redundant));
    }
    if (!is_simple || speed(own_.output) == 0 || speed(own_.inputs[0]) == 0) return;
    const int input = own_.inputs[0];
    const UnitLoads unit = unit_loads(own_.train, member_speeds_, input, own_.output);
    if (unit.efficiency > 0) {
      add("torque_ratio", unit.forward->external[at(own_.output)] / sign_of(speed(input)));
      add("efficiency", unit.efficiency);
    } else {
      note(fmt::format(
          "The train is self-locking: driven at \"{}\" it cannot move \"{}\" against a load.",
          own_.names[at(input)], own_.names[at(own_.output)]));
    }
    add("self_locking", !(unit.efficiency > 0));
    if (unit.reverse_efficiency > 0) add("reverse_efficiency", unit.reverse_efficiency);
    add("reverse_self_locking", !(unit.reverse_efficiency > 0));
  }

  /// The torques of the file, or 1 N m that drives the first input.
  void add_loads() {
    std::vector<KnownTorque> known;
    std::vector<int> unknown;
    const auto take = [&](int member, const std::optional<double>& torque) {
      if (torque) {
        known.push_back({member, *torque});
      } else {
        unknown.push_back(member);
      }
    };
    for (std::size_t k = 0; k < own_.inputs.size(); ++k) {
      take(own_.inputs[k], problem_.inputs[k].torque);
    }
    if (has_output()) take(own_.output, problem_.output->torque);
    if (speeds_.redundant > 0 || !has_output()) return;
    if (known.empty()) {
      known.push_back({unknown.front(), sign_of(speed(unknown.front()))});
      unknown.erase(unknown.begin());
    }
    if (std::ssize(unknown) != speeds_.freedom || !speeds_of(own_.train, unknown).is_determined()) {
      note(fmt::format(
          "Torques are not determined: {} given, expected {} of those of the {} inputs "
          "and the output.",
          known.size(), own_.inputs.size() + 1 - at(speeds_.freedom), own_.inputs.size()));
      return;
    }
    const auto found = loads(known, unknown);
    if (!found) {
      set_self_locking();
      note(
          "With these torques the train is self-locking: no sense of the power through its meshes "
          "agrees with the torques that follow from it.");
      return;
    }
    show(*found);
  }

  void set_self_locking() {
    const auto own = std::ranges::find(design_.metrics, "self_locking", &Quantity::name);
    if (own == design_.metrics.end()) {
      add("self_locking", true);
    } else {
      own->value = true;
    }
  }

  void show(const TrainLoads& loads) {
    double loss = 0, given = 0;
    for (int i = 0; i < own_.train.members; ++i) {
      TrainMember& member = design_.members[at(i)];
      const bool is_outside = i == own_.output ||
                              std::ranges::find(own_.inputs, i) != own_.inputs.end() ||
                              std::ranges::find(own_.train.fixed, i) != own_.train.fixed.end();
      if (!is_outside) continue;
      member.torque = loads.external[at(i)];
      member.power = loads.external[at(i)] * speed(i);
      given += std::max(0.0, *member.power);
    }
    for (std::size_t k = 0; k < loads.torque.size(); ++k) {
      design_.meshes.push_back({loads.torque[k], loads.power[k], loads.loss[k], 0});
      loss += loads.loss[k];
    }
    add("power_W", given);
    add("loss_W", loss);
    if (own_.inputs.size() > 1 && given > 0) add("efficiency", 1 - loss / given);
  }

  void add_inertia() {
    const double sum = doubled_energy(problem_, own_, member_speeds_);
    if (!(sum > 0) || own_.inputs.size() != 1) return;
    for (int i = 0; i < own_.train.members; ++i) {
      const double own = speed(i);
      if (own != 0) design_.members[at(i)].equivalent_inertia = sum / (own * own);
    }
    add("equivalent_inertia_kg_m2", *design_.members[at(own_.inputs[0])].equivalent_inertia);
  }

  void add_planets() {
    design_.meshes.resize(problem_.meshes.size());
    for (std::size_t k = 0; k < own_.sized.size(); ++k) {
      design_.meshes[k].centre_distance =
          own_.sized[k].is_bevel ? 0 : centre_distance(own_.sized[k]);
    }
    for (const auto& planet : own_.planets) add_planet(planet);
    for (const auto& assembly : assemblies(own_.sized, own_.planets)) {
      const auto& planet = own_.planets[at(assembly.planet)];
      if (planet.count < 2) continue;
      const std::string name = fmt::format("planet_assembly.{}", own_.names[at(planet.member)]);
      const auto has_name = [&](const ConstraintCheck& check) { return check.name == name; };
      const auto before = std::ranges::find_if(design_.constraints, has_name);
      if (before != design_.constraints.end()) {
        if (!assembly.fits) before->value = "does not fit", before->satisfied = false;
        continue;
      }
      design_.constraints.push_back(
          {name, assembly.fits ? "fits" : "does not fit", "fits", assembly.fits});
    }
  }

  void add_planet(const train::Planet& planet) {
    TrainMember& member = design_.members[at(planet.member)];
    const auto radii = orbit_radii(planet, own_.sized, own_.planets);
    if (radii.empty()) return;
    member.orbit_radius = radii.front();
    const auto [least, most] = std::ranges::minmax(radii);
    if (most - least > kSameRadius * most) {
      design_.warnings.push_back(
          fmt::format("Planet \"{}\" would need orbits of radius {:.6g} and {:.6g}: its gears are "
                      "coaxial only with profile shifts or unequal modules.",
                      member.name, least, most));
    }
    member.neighbour_clearance = neighbour_clearance(planet, own_.sized, own_.planets);
    if (!member.neighbour_clearance) return;
    design_.constraints.push_back(
        {"neighbour_clearance." + member.name, *member.neighbour_clearance, 0.0,
         *member.neighbour_clearance > 0, std::nullopt, BoundSide::least});
  }

  const GearTrainProblem& problem_;
  ResolvedTrain own_;
  train::TrainSpeeds speeds_;
  std::vector<double> input_speeds_, member_speeds_;
  GearTrainDesign design_;
};

}  // namespace

GearTrainDesign analysed_train(const GearTrainProblem& problem, const TrainState* state,
                               const std::string& origin) {
  return TrainAnalysis(problem, state, origin).made();
}

}  // namespace cognate::problems
