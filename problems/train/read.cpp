/// A gear train of a file: its tables, then whether its names and its structure make sense.
#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "problems/toml/table_reader.hpp"
#include "problems/train/check.hpp"
#include "problems/train/keys.hpp"
#include "problems/train/read_target.hpp"

namespace cognate::problems::reading {
namespace {

using Names = std::vector<std::string>;

constexpr NumberRule kTrainTeeth{[](double x) {
                                   return x >= kFewestTrainTeeth && x <= kMostTrainTeeth &&
                                          x == static_cast<int>(x);
                                 },
                                 "a whole number from 3 to 10000"};

/// Faults a key that is missing.
void require(TableReader& table, std::string_view key, std::string_view wanted) {
  if (!table.has(key)) table.fault(key, fmt::format("is missing; expected {}", wanted));
}

/// A name of a member: it stands before a dot in names of metrics.
void check_name(TableReader& table, std::string_view key, const std::string& name) {
  const bool is_odd = std::ranges::any_of(name, [](char c) {
    return c == '.' || c == '[' || c == ']' || static_cast<unsigned char>(c) < ' ';
  });
  if (table.contains(key) && (name.empty() || name.size() > 40 || is_odd)) {
    table.fault(key, "is no name; expected 1 to 40 bytes without dots and brackets");
  }
}

std::array<std::string, 2> read_two_names(TableReader& table, std::string_view key) {
  require(table, key, "the names of two members");
  const auto names = table.texts(key, {2, 2, "names"});
  if (!names) return {};
  for (const auto& name : *names) check_name(table, key, name);
  if ((*names)[0] == (*names)[1]) {
    table.fault(key, "names one member twice; expected two different ones");
  }
  return {(*names)[0], (*names)[1]};
}

TrainMesh read_mesh(TableReader& table) {
  TrainMesh mesh;
  mesh.gears = read_two_names(table, "gears");
  require(table, "teeth", "[za, zb]");
  const auto teeth = table.two("teeth", kTrainTeeth, "[za, zb]");
  if (teeth) mesh.teeth = {static_cast<int>((*teeth)[0]), static_cast<int>((*teeth)[1])};
  read_keys(table, kTrainMeshKeys, mesh);
  if (teeth && mesh.type == MeshType::internal && mesh.teeth[0] == mesh.teeth[1]) {
    table.fault("teeth",
                "are as many of the internal gear as of the one in it; expected more of "
                "one of them");
  }
  table.finish();
  return mesh;
}

/// The tables under `key`, each by `read`.
template <class Entry, class Read>
std::vector<Entry> read_each(TableReader& document, std::string_view key, std::size_t most,
                             Read read, std::size_t least = 0) {
  std::vector<Entry> all;
  for (TableReader& table : document.tables(key, {least, most, "tables"})) {
    all.push_back(read(table));
  }
  return all;
}

template <class Entry, class Keys>
Entry read_named(TableReader& table, const Keys& keys, std::string_view name_key) {
  Entry entry;
  require(table, name_key, "a name");
  read_keys(table, keys, entry);
  return entry;
}

void read_train(TableReader& document, GearTrainProblem& problem) {
  problem.meshes = read_each<TrainMesh>(document, "mesh", kMostMeshes, read_mesh, 1);
  problem.planets =
      read_each<TrainPlanet>(document, "planet", kMostMembers, [](TableReader& table) {
        auto planet = read_named<TrainPlanet>(table, kTrainPlanetKeys, "name");
        require(table, "carrier", "the name of a member");
        check_name(table, "carrier", planet.carrier);
        table.finish();
        return planet;
      });
  problem.shafts = read_each<TrainShaft>(document, "shaft", kMostMembers, [](TableReader& table) {
    auto shaft = read_named<TrainShaft>(table, kTrainShaftKeys, "name");
    table.finish();
    return shaft;
  });
  problem.brakes = read_each<TrainBrake>(document, "brake", kMostMembers, [](TableReader& table) {
    auto brake = read_named<TrainBrake>(table, kTrainBrakeKeys, "name");
    require(table, "holds", "the name of a member");
    table.finish();
    return brake;
  });
  problem.clutches =
      read_each<TrainClutch>(document, "clutch", kMostMembers, [](TableReader& table) {
        auto clutch = read_named<TrainClutch>(table, kTrainClutchKeys, "name");
        clutch.joins = read_two_names(table, "joins");
        table.finish();
        return clutch;
      });
  problem.inputs = read_each<TrainInput>(document, "input", kMostMembers, [](TableReader& table) {
    auto input = read_named<TrainInput>(table, kTrainInputKeys, "member");
    table.finish();
    return input;
  });
  problem.states = read_each<TrainState>(document, "state", kMostStates, [](TableReader& table) {
    auto state = read_named<TrainState>(table, kTrainStateKeys, "name");
    check_name(table, "name", state.name);
    state.engaged = table.texts("engaged", {0, kMostMembers, "names"}).value_or(Names{});
    table.finish();
    return state;
  });
  TableReader mechanism = document.table("mechanism");
  problem.fixed = mechanism.texts("fixed", {0, kMostMembers, "names"}).value_or(Names{});
  mechanism.finish();
  if (!document.has("output")) return;
  TableReader output = document.table("output");
  problem.output = read_named<TrainOutput>(output, kTrainOutputKeys, "member");
  output.finish();
}

/// What a train that is to be found has not.
void refuse_given(TableReader& document) {
  for (const std::string_view key :
       {"mesh", "planet", "shaft", "mechanism", "brake", "clutch", "state", "input", "output"}) {
    if (document.contains(key) && document.has(key)) {
      document.fault(key,
                     "is given beside target, with which a train is found; remove one of them");
    }
  }
}

}  // namespace
}  // namespace cognate::problems::reading

namespace cognate::problems {

GearTrainProblem KindTraits<GearTrainProblem>::read(reading::TableReader& document,
                                                    const std::filesystem::path& /*folder*/) {
  using namespace reading;
  GearTrainProblem problem;
  if (document.has("target")) {
    refuse_given(document);
    problem.target = read_train_target(document);
    return problem;
  }
  for (const std::string_view key : {"bounds", "solve"}) {
    if (document.contains(key) && document.has(key)) {
      document.fault(key, "is given, but nothing is to be found; expected [target] with it");
    }
  }
  if (!document.has("mesh")) {
    document.fault("mesh",
                   "is missing; expected [[mesh]] tables of a train, or [target] with the "
                   "ratio of one that is to be found");
  }
  const std::size_t before = document.faults().size();
  read_train(document, problem);
  if (document.faults().size() == before && !problem.meshes.empty()) {
    check_train(document, problem);
  }
  return problem;
}

}  // namespace cognate::problems
