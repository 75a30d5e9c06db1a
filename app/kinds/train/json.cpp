#include <cmath>
#include <nlohmann/json.hpp>

#include "app/documents/json_values.hpp"
#include "app/kinds/train/kind.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;
using problems::GearTrainDesign;
using problems::GearTrainProblem;
using problems::TrainMember;

void set_if(ordered_json& table, const char* key, const std::optional<double>& value) {
  if (value && std::isfinite(*value)) table[key] = *value;
}

ordered_json member_json(const TrainMember& member) {
  ordered_json table = {{"role", member.role}};
  if (!member.speed_exact.empty()) table["speed_exact"] = member.speed_exact;
  set_if(table, "speed_rad_s", member.speed);
  set_if(table, "relative_speed_rad_s", member.relative_speed);
  set_if(table, "torque_N_m", member.torque);
  set_if(table, "power_W", member.power);
  set_if(table, "equivalent_inertia_kg_m2", member.equivalent_inertia);
  set_if(table, "orbit_radius", member.orbit_radius);
  set_if(table, "neighbour_clearance", member.neighbour_clearance);
  return table;
}

ordered_json meshes_json(const GearTrainDesign& design) {
  ordered_json list = ordered_json::array();
  for (std::size_t k = 0; k < design.meshes.size(); ++k) {
    const auto& mesh = design.meshes[k];
    ordered_json table = {{"gears", design.settled.meshes[k].gears}};
    if (mesh.centre_distance > 0) table["centre_distance"] = mesh.centre_distance;
    set_if(table, "torque_N_m", mesh.torque);
    set_if(table, "power_W", mesh.power);
    set_if(table, "loss_W", mesh.loss);
    list.push_back(std::move(table));
  }
  return list;
}

ordered_json metrics_json(const GearTrainDesign& design) {
  const bool has_planets = !design.settled.planets.empty();
  ordered_json table = {{"class", has_planets ? "epicyclic" : "fixed-axis"}};
  add_finite_quantities(table, design.metrics);
  ordered_json members = ordered_json::object();
  for (const TrainMember& member : design.members) members[member.name] = member_json(member);
  table["members"] = members;
  table["meshes"] = meshes_json(design);
  table["transmission_angle_deg"] = nullptr;
  table["time_ratio"] = nullptr;
  table["defects"] = ordered_json::array();
  return table;
}

ordered_json train_mechanism_json(const GearTrainDesign& design) {
  ordered_json mechanism = {{"type", "gear-train"}};
  ordered_json tables = problem_json(design.settled);
  for (const char* key : {"kind", "title", "length_unit", "state"}) tables.erase(key);
  if (tables.contains("mechanism")) {
    mechanism["fixed"] = tables["mechanism"]["fixed"];
    tables.erase("mechanism");
  }
  mechanism.update(tables);
  for (const auto& state : design.settled.states) {
    if (state.name == design.state) mechanism["engaged"] = state.engaged;
  }
  return mechanism;
}

}  // namespace

ordered_json Kind<GearTrainProblem>::design_json(const GearTrainProblem& /*problem*/,
                                                 const Result& result, std::size_t index) {
  const GearTrainDesign& design = result.designs[index];
  ordered_json table = {{"mechanism", train_mechanism_json(design)},
                        {"crank_deg", ordered_json::array()},
                        {"error", {{"sum_of_squares", 0.0}, {"rms", 0.0}, {"max", 0.0}}},
                        {"metrics", metrics_json(design)},
                        {"constraints", ordered_json::array()}};
  for (const auto& check : design.constraints) table["constraints"].push_back(to_json(check));
  table["origin"] = design.origin;
  table["warnings"] = design.warnings;
  return table;
}

ExportOutcome Kind<GearTrainProblem>::export_design(const ResultDesign& design,
                                                    const ExportOptions& /*wanted*/,
                                                    const std::string& /*stem*/) {
  return tl::unexpected(ExportRefusal{
      design.name +
          ": the gears of a gear-train have numbers of teeth and no outline; expected the "
          "result of a linkage, a cam or a gear",
      true});
}

}  // namespace cognate::app
