/// A gear train written down, and checked by reading what was written.
#include "problems/linkage/write_linkage.hpp"
#include "problems/toml/table_writer.hpp"
#include "problems/train/keys.hpp"
#include "problems/train/problem.hpp"

namespace cognate::problems {
namespace reading {
namespace {

template <class Entry, class Write>
void write_each(TableWriter& document, std::string_view key, const std::vector<Entry>& entries,
                Write write) {
  if (entries.empty()) return;
  Array all;
  for (const Entry& entry : entries) all.push_back(node(write(entry)));
  document.set(key, all);
}

TableWriter mesh_writer(const TrainMesh& mesh) {
  TableWriter table;
  table.set("gears", mesh.gears).set("teeth", mesh.teeth);
  return write_keys(mesh, kTrainMeshKeys, table);
}

template <class Entry, class Keys>
TableWriter keys_writer(const Entry& entry, const Keys& keys) {
  TableWriter table;
  return write_keys(entry, keys, table);
}

void write_train(const GearTrainProblem& problem, TableWriter& document) {
  write_each(document, "mesh", problem.meshes, mesh_writer);
  write_each(document, "planet", problem.planets,
             [](const auto& entry) { return keys_writer(entry, kTrainPlanetKeys); });
  write_each(document, "shaft", problem.shafts,
             [](const auto& entry) { return keys_writer(entry, kTrainShaftKeys); });
  if (!problem.fixed.empty()) {
    document.set("mechanism", TableWriter{}.set("fixed", problem.fixed));
  }
  write_each(document, "brake", problem.brakes,
             [](const auto& entry) { return keys_writer(entry, kTrainBrakeKeys); });
  write_each(document, "clutch", problem.clutches, [](const TrainClutch& clutch) {
    return keys_writer(clutch, kTrainClutchKeys).set("joins", clutch.joins);
  });
  write_each(document, "state", problem.states, [](const TrainState& state) {
    return keys_writer(state, kTrainStateKeys).set("engaged", state.engaged);
  });
  write_each(document, "input", problem.inputs,
             [](const auto& entry) { return keys_writer(entry, kTrainInputKeys); });
  if (problem.output) document.set("output", keys_writer(*problem.output, kTrainOutputKeys));
}

void write_target(const TrainTarget& target, TableWriter& document) {
  const bool is_planetary = target.train == TrainType::planetary;
  TableWriter keys, bounds;
  for (const auto& key : kTrainTargetKeys) {
    const bool is_other =
        is_planetary ? key.name == "coaxial" : key.name == "input" || key.name == "output";
    if (!is_other) key.write(target, key, keys);
  }
  bounds.set("teeth", target.teeth);
  if (is_planetary) {
    bounds.set("ring_teeth", target.ring_teeth).set("planets", target.planets);
  } else {
    bounds.set("pairs", target.pairs);
  }
  document.set("target", keys)
      .set("bounds", bounds)
      .set("solve", TableWriter{}.set("designs", target.designs));
}

}  // namespace
}  // namespace reading

reading::Written KindTraits<GearTrainProblem>::written(const GearTrainProblem& problem) {
  reading::TableWriter document =
      reading::document_writer(kWord, problem.title, problem.length_unit);
  reading::write_train(problem, document);
  if (problem.target) reading::write_target(*problem.target, document);
  return {document.take(), {}};
}

tl::expected<GearTrainProblem, std::vector<std::string>> KindTraits<GearTrainProblem>::checked(
    const GearTrainProblem& problem) {
  return reading::read_back(problem).map([&](const auto&) { return problem; });
}

}  // namespace cognate::problems
