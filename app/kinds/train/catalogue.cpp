#include "app/kinds/train/kind.hpp"
#include "app/study/metrics.hpp"
#include "problems/train/keys.hpp"
#include "problems/train/resolve.hpp"

namespace cognate::app {
namespace {

using namespace problems::reading;

constexpr auto kMeshes = entries_of(kTrainMeshKeys);
constexpr auto kPlanets = entries_of(kTrainPlanetKeys);
constexpr auto kShafts = entries_of(kTrainShaftKeys);
constexpr auto kInputs = entries_of(kTrainInputKeys);
constexpr auto kTrainOutput = entries_of(kTrainOutputKeys);
constexpr auto kBrakes = entries_of(kTrainBrakeKeys);
constexpr auto kClutches = entries_of(kTrainClutchKeys);
constexpr auto kStates = entries_of(kTrainStateKeys);
constexpr auto kTrainTarget = entries_of(kTrainTargetKeys);

constexpr Entry kTrainMechanism[] = {{"fixed", "[\"ring\"], members that never turn"}};

constexpr Entry kTrainBounds[] = {
    {"teeth", "[min, max] of every gear, or of sun and planets (default [17, 100])"},
    {"pairs", "[min, max] pairs of a compound train, 1 to 4 (default [1, 3])"},
    {"ring_teeth", "planetary: [min, max] (default [40, 200])"},
    {"planets", "planetary: [min, max] of their number (default [3, 3])"}};

constexpr Entry kTrainSolve[] = {{"designs", "1 to 100 (default 3)"}};

constexpr KeyedEntry kTrainTables[] = {
    {"[[mesh]]", "two gears in mesh; a member is all that turns as one", kMeshes},
    {"[[planet]]", "a member whose axis goes round with a carrier", kPlanets},
    {"[[shaft]]", "members: what they have in addition to gears", kShafts},
    {"[mechanism]", "what is fixed", kTrainMechanism},
    {"[[input]]", "a member that is driven, one for each degree of freedom", kInputs},
    {"[output]", "the member that drives", kTrainOutput},
    {"[[brake]]", "of a gearbox", kBrakes},
    {"[[clutch]]", "of a gearbox", kClutches},
    {"[[state]]", "of a gearbox, a row of its table", kStates},
    {"[target]", "instead of all these: the train that is to be found", kTrainTarget},
    {"[bounds]", "of a train that is to be found", kTrainBounds},
    {"[solve]", "how many trains are returned", kTrainSolve}};

constexpr Metric kTrainMetrics[] = {
    {"state", "", "of a gearbox: its name"},
    {"ratio", "1", "input speed over output speed, negative where they turn against each other"},
    {"ratio_exact", "", "the same as a fraction, without rounding"},
    {"ratio_error", "1", "of a train that was found: relative"},
    {"degrees_of_freedom", "1", "of the train before its inputs"},
    {"output_speed_rad_s", "rad/s", "of the output"},
    {"torque_ratio", "1", "torque on the output over that on the input, both from outside"},
    {"efficiency", "1", "output power over input power"},
    {"reverse_efficiency", "1", "the same where the output drives"},
    {"self_locking", "boolean", "whether the input cannot drive a load, for losses"},
    {"reverse_self_locking", "boolean", "whether the output cannot drive the input"},
    {"power_W", "W", "that enters from outside"},
    {"loss_W", "W", "of all meshes"},
    {"equivalent_inertia_kg_m2", "kg m2", "of the whole train at the input"},
    {"teeth_sum", "1", "of all meshes"},
    {"teeth_max", "1", "of the largest gear"}};

constexpr Metric kMemberMetrics[] = {
    {"speed_rad_s", "rad/s", "of a member"},
    {"relative_speed_rad_s", "rad/s", "of a planet, to its carrier"},
    {"torque_N_m", "N m", "from outside: of inputs, output and fixed members"},
    {"power_W", "W", "by this torque; negative: it leaves the train here"},
    {"equivalent_inertia_kg_m2", "kg m2", "of the whole train at this member"},
    {"orbit_radius", "length", "of a planet, in modules where no mesh has a module"},
    {"neighbour_clearance", "length", "between the tips of neighbouring planets, likewise"}};

}  // namespace

problems::MetricNames Kind<problems::GearTrainProblem>::metric_names(
    const problems::GearTrainProblem& base) {
  problems::MetricNames names;
  add_metrics(names, kTrainMetrics);
  for (const std::string& member : problems::member_names(base)) {
    add_metrics(names, kMemberMetrics, "members." + member + ".");
  }
  for (const char* word : {"class", "defects", "origin"}) names.names.push_back({word, true});
  for (const char* opening : {"mechanism.mesh", "mechanism.planet"}) {
    names.openings.emplace_back(opening);
  }
  return names;
}

std::vector<ListSection> Kind<problems::GearTrainProblem>::sections() {
  return {list_section("gear_train_tables", "tables of a gear train", kTrainTables)};
}

std::vector<MetricList> Kind<problems::GearTrainProblem>::metric_lists() {
  return {{"gear_train_metrics", "metric of a gear train", kTrainMetrics},
          {"gear_train_member_metrics", "metric of its members (members.NAME. before it)",
           kMemberMetrics}};
}

}  // namespace cognate::app
