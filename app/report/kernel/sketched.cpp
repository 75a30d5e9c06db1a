#include "app/report/kernel/sketched.hpp"

#include <string>
#include <utility>

#include "analysis/linkage/mobility.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/chain/verify.hpp"
#include "problems/guidance/design.hpp"
#include "problems/straight_line/normalised.hpp"

namespace cognate::page {
namespace {

using json = nlohmann::ordered_json;
using problems::Design;

json pair(const Vec2d& point) {
  return json::array({point.x, point.y});
}

/// Of a generator of functions its start angles, and errors in degrees too.
void add_starts(const problems::Metrics& metrics, json& entry) {
  if (!metrics.input_start || !metrics.output_start) return;
  entry["input_start_deg"] = problems::degrees(*metrics.input_start);
  entry["output_start_deg"] = problems::degrees(*metrics.output_start);
  for (const char* error : {"rms", "max"})
    entry[error] = entry[error].get<double>() * kDegreesInRadian;
}

json entry_of(const Design& design, MechanismOf mechanism_of) {
  json angles = json::array();
  for (const double angle : design.crank_angles) angles.push_back(problems::degrees(angle));
  const auto& metrics = design.metrics;
  json mechanism = mechanism_of(design);
  const json type = mechanism["type"];
  json entry{{"mechanism", std::move(mechanism)},
             {"crank_deg", std::move(angles)},
             {"rms", design.error.rms},
             {"max", design.error.max},
             {"class", metrics.mobility ? json(problems::to_string(*metrics.mobility)) : type},
             {"transmission_acute_min_deg", problems::degrees(metrics.transmission_acute_min)}};
  const auto body = find_quantity(metrics.quantities, problems::kBodyAngleKey);
  const auto turned = find_quantity(metrics.quantities, problems::kAngleErrorKey);
  if (body && turned) {
    entry["body_angle_deg"] = problems::degrees(*body);
    entry["angle_max_deg"] = problems::degrees(*turned);
  }
  if (const auto stray = find_quantity(metrics.quantities, problems::kStrayKey)) {
    entry["stray"] = *stray;
  }
  if (const auto along = find_quantity(metrics.quantities, problems::kLineDirectionKey)) {
    entry["direction_deg"] = problems::degrees(*along);
    entry["speed_variation"] =
        find_quantity(metrics.quantities, problems::kSpeedVariationKey).value_or(0);
  }
  add_starts(metrics, entry);
  return entry;
}

}  // namespace

json four_bar_of(const Design& design) {
  const FourBar& linkage = four_bar(design);
  json mechanism{{"type", "four-bar"},
                 {"fixed_pivots", {pair(linkage.pivot_a), pair(linkage.pivot_d)}},
                 {"crank", linkage.crank},
                 {"coupler", linkage.coupler},
                 {"rocker", linkage.rocker}};
  if (linkage.coupler_point) mechanism["coupler_point"] = pair(*linkage.coupler_point);
  mechanism["assembly"] = linkage.assembly == Assembly::open ? "open" : "crossed";
  return mechanism;
}

void require_target(problems::reading::TableReader& target, std::string_view key) {
  if (!target.has(key)) target.fault(key, "is missing");
}

std::vector<Design> read_known(problems::reading::TableReader& document, std::size_t targets) {
  constexpr std::size_t kAngle = 10, kFirst = 11, kMost = 20;
  std::vector<Design> known;
  const auto rows = document.each_row("known", kFirst + targets, problems::reading::kNumber,
                                      "rows of eleven numbers and the crank's angles",
                                      {.max = kMost, .of = "designs"});
  for (const auto& row : rows) {
    if (!row) continue;
    const std::vector<double>& v = *row;
    const FourBar linkage{{v[0], v[1]},
                          {v[2], v[3]},
                          v[4],
                          v[5],
                          v[6],
                          v[9] == 1 ? Assembly::open : Assembly::crossed,
                          Vec2d{v[7], v[8]}};
    Design design;
    design.mechanism.description = linkage;
    design.metrics.quantities.push_back(
        quantity(problems::kBodyAngleKey, problems::reading::radians(v[kAngle])));
    for (std::size_t i = kFirst; i < v.size(); ++i) {
      design.crank_angles.push_back(problems::reading::radians(v[i]));
    }
    known.push_back(std::move(design));
  }
  return known;
}

problems::Run run_of(const SketchQuestion& question, std::vector<Design> known) {
  problems::Run run;
  run.seed = question.seed;
  run.threads = 1;
  run.known = std::move(known);
  return run;
}

json sketched(const std::vector<Design>& designs, MechanismOf mechanism_of) {
  json entries = json::array();
  for (const Design& design : designs) entries.push_back(entry_of(design, mechanism_of));
  return {{"designs", std::move(entries)}};
}

}  // namespace cognate::page
