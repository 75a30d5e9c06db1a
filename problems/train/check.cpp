#include "problems/train/check.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>

#include "problems/toml/nearest.hpp"
#include "problems/train/resolve.hpp"

namespace cognate::problems::reading {
namespace {

using Tables = std::vector<TableReader>;

class TrainCheck {
 public:
  TrainCheck(TableReader& document, const GearTrainProblem& problem)
      : document_(document), problem_(problem), names_(member_names(problem)) {}

  void check() {
    check_planets();
    check_meshes();
    check_each("shaft", problem_.shafts, "name", &TrainShaft::name);
    check_each("brake", problem_.brakes, "holds", &TrainBrake::holds);
    check_each("input", problem_.inputs, "member", &TrainInput::member);
    check_clutches();
    check_fixed();
    check_output();
    check_states();
    if (problem_.inputs.empty()) {
      document_.fault("input", "is missing; expected an [[input]] with its member");
    }
  }

 private:
  Tables tables(std::string_view key) { return document_.tables(key, {0, 10000, "tables"}); }

  const TrainPlanet* planet(const std::string& name) const {
    const auto found = std::ranges::find(problem_.planets, name, &TrainPlanet::name);
    return found == problem_.planets.end() ? nullptr : &*found;
  }

  void check_member(TableReader& table, std::string_view key, const std::string& name) {
    if (std::ranges::find(names_, name) == names_.end()) {
      const std::vector<std::string_view> known(names_.begin(), names_.end());
      const auto meant = nearest(name, known);
      table.fault(key, fmt::format("is {}, no gear of any mesh and no carrier{}; allowed are {}",
                                   in_quotes(name),
                                   meant ? fmt::format(", perhaps for \"{}\"", *meant) : "",
                                   quoted_list(known)));
    } else if (planet(name)) {
      table.fault(key, fmt::format("is {}, a planet; expected a member on the fixed axis",
                                   in_quotes(name)));
    }
  }

  void check_twice(TableReader& table, std::string_view key, const std::string& name,
                   std::vector<std::string>& before) {
    if (std::ranges::find(before, name) != before.end()) {
      table.fault(key, fmt::format("is {} a second time; expected each once", in_quotes(name)));
    }
    before.push_back(name);
  }

  template <class Entry>
  void check_each(std::string_view where, const std::vector<Entry>& entries, std::string_view key,
                  std::string Entry::*name) {
    std::vector<std::string> before;
    Tables all = tables(where);
    for (std::size_t i = 0; i < entries.size(); ++i) {
      check_member(all[i], key, entries[i].*name);
      if constexpr (!std::is_same_v<Entry, TrainBrake>) {
        check_twice(all[i], key, entries[i].*name, before);
      }
    }
  }

  void check_planets() {
    std::vector<std::string> before;
    Tables all = tables("planet");
    for (std::size_t i = 0; i < problem_.planets.size(); ++i) {
      const TrainPlanet& own = problem_.planets[i];
      const bool meshes = std::ranges::any_of(problem_.meshes, [&](const TrainMesh& mesh) {
        return std::ranges::find(mesh.gears, own.name) != mesh.gears.end();
      });
      check_twice(all[i], "name", own.name, before);
      if (!meshes) {
        all[i].fault("name", fmt::format("is {}, in no mesh; expected a gear of a mesh",
                                         in_quotes(own.name)));
      }
      if (planet(own.carrier)) {
        all[i].fault("carrier", fmt::format("is {}, a planet itself; expected a member on the "
                                            "fixed axis",
                                            in_quotes(own.carrier)));
      }
      if (own.mass > 0) check_mass(all[i], own);
    }
  }

  void check_mass(TableReader& table, const TrainPlanet& own) {
    const bool has_module = std::ranges::any_of(problem_.meshes, [&](const TrainMesh& mesh) {
      return mesh.module && std::ranges::find(mesh.gears, own.name) != mesh.gears.end();
    });
    if (!has_module) {
      table.fault("mass",
                  "is given, but no mesh of the planet has a module, by which its orbit is "
                  "known; expected module");
    }
  }

  void check_meshes() {
    Tables all = tables("mesh");
    for (std::size_t i = 0; i < problem_.meshes.size(); ++i) {
      const auto& [one, other] = problem_.meshes[i].gears;
      const auto *first = planet(one), *second = planet(other);
      if (first && second && (first->carrier != second->carrier || first->count != second->count)) {
        all[i].fault("gears",
                     "are planets of different carriers or counts; expected those of one "
                     "carrier, equally many");
      }
      for (const auto* own : {first, second}) {
        if (own && (own->carrier == one || own->carrier == other)) {
          all[i].fault("gears", "are a planet and its own carrier; expected a gear beside it");
        }
      }
    }
  }

  void check_clutches() {
    Tables all = tables("clutch");
    std::vector<std::string> before;
    for (const auto& brake : problem_.brakes) before.push_back(brake.name);
    for (std::size_t i = 0; i < problem_.clutches.size(); ++i) {
      for (const auto& name : problem_.clutches[i].joins) check_member(all[i], "joins", name);
      check_twice(all[i], "name", problem_.clutches[i].name, before);
    }
  }

  void check_fixed() {
    TableReader mechanism = document_.table("mechanism");
    std::vector<std::string> before;
    for (const auto& name : problem_.fixed) {
      check_member(mechanism, "fixed", name);
      check_twice(mechanism, "fixed", name, before);
    }
  }

  void check_output() {
    if (!problem_.output) return;
    TableReader output = document_.table("output");
    check_member(output, "member", problem_.output->member);
    const auto is_same = [&](const TrainInput& input) {
      return input.member == problem_.output->member;
    };
    if (std::ranges::any_of(problem_.inputs, is_same)) {
      output.fault("member", "is an input too; expected another member");
    }
  }

  void check_states() {
    Tables all = tables("state");
    std::vector<std::string> before;
    for (std::size_t i = 0; i < problem_.states.size(); ++i) {
      check_twice(all[i], "name", problem_.states[i].name, before);
      std::vector<std::string> engaged;
      for (const auto& name : problem_.states[i].engaged) {
        const bool is_known =
            std::ranges::find(problem_.brakes, name, &TrainBrake::name) != problem_.brakes.end() ||
            std::ranges::find(problem_.clutches, name, &TrainClutch::name) !=
                problem_.clutches.end();
        if (!is_known) {
          all[i].fault("engaged", fmt::format("holds {}, no brake and no clutch; expected the name "
                                              "of a [[brake]] or [[clutch]]",
                                              in_quotes(name)));
        }
        check_twice(all[i], "engaged", name, engaged);
      }
    }
  }

  TableReader& document_;
  const GearTrainProblem& problem_;
  std::vector<std::string> names_;
};

/// That the inputs determine every speed, once, in each state.
class FreedomCheck {
 public:
  FreedomCheck(TableReader& document, const GearTrainProblem& problem)
      : document_(document), problem_(problem) {}

  void check() {
    for (const TrainState* state : states_of(problem_)) check(state);
  }

 private:
  void check(const TrainState* state) {
    const ResolvedTrain own = resolved(problem_, state);
    const train::TrainSpeeds speeds = speeds_of(own.train, own.inputs);
    for (const int place : speeds.excess) {
      const bool is_locked = std::ranges::find(speeds.locked, place) != speeds.locked.end();
      const std::string name = in_quotes(problem_.inputs[static_cast<std::size_t>(place)].member);
      say(state, place,
          is_locked ? fmt::format("{} cannot turn, since meshes and fixed members lock it; "
                                  "expected fewer of them",
                                  name)
                    : fmt::format("{} has a speed that follows from the other inputs; expected {} "
                                  "for {}",
                                  name, count_of(speeds.freedom, "input"),
                                  count_of(speeds.freedom, "degree of freedom")));
    }
    if (speeds.undetermined.empty() || !speeds.excess.empty()) return;
    const auto is_shaft = [&](int member) {
      return std::ranges::find(own.planets, member, &train::Planet::member) == own.planets.end();
    };
    const auto shaft = std::ranges::find_if(speeds.undetermined, is_shaft);
    const int first = shaft == speeds.undetermined.end() ? speeds.undetermined.front() : *shaft;
    say(state, -1,
        fmt::format("{} not determined: the train has {} and {}; expected as many inputs, or more "
                    "fixed members",
                    in_quotes(own.names[static_cast<std::size_t>(first)]) + "'s speed is",
                    count_of(speeds.freedom, "degree of freedom"),
                    count_of(static_cast<int>(own.inputs.size()), "input")));
  }

  static std::string count_of(int count, std::string_view what) {
    if (count == 1) return fmt::format("1 {}", what);
    return what.starts_with("degree") ? fmt::format("{} degrees of freedom", count)
                                      : fmt::format("{} {}s", count, what);
  }

  void say(const TrainState* state, int input, const std::string& what) {
    if (state) {
      auto all = document_.tables("state", {0, 10000, "tables"});
      const auto place = static_cast<std::size_t>(state - problem_.states.data());
      all[place].fault("name", fmt::format("is {}, where {}", in_quotes(state->name), what));
    } else if (input >= 0) {
      auto all = document_.tables("input", {0, 10000, "tables"});
      all[static_cast<std::size_t>(input)].fault("member", "is wrong: " + what);
    } else {
      document_.fault("input", "is wrong: " + what);
    }
  }

  TableReader& document_;
  const GearTrainProblem& problem_;
};

}  // namespace

void check_train(TableReader& document, const GearTrainProblem& problem) {
  const std::size_t before = document.faults().size();
  TrainCheck(document, problem).check();
  if (document.faults().size() == before) FreedomCheck(document, problem).check();
}

}  // namespace cognate::problems::reading
