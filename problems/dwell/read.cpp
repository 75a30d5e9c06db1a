#include "problems/chain/front/read.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "analysis/numbers/constants.hpp"
#include "problems/chain/read_design.hpp"
#include "problems/chain/read_made.hpp"
#include "problems/dwell/given.hpp"
#include "problems/dwell/raster.hpp"
#include "problems/linkage/warnings.hpp"

namespace cognate::problems {
namespace reading {
namespace {

constexpr std::string_view kDwell = "dwell", kOutput = "output";

constexpr NumberRule kPartOfTurn{[](double x) { return x > 0 && x < 360; },
                                 "an angle in degrees above 0 and below 360"};
constexpr NumberRule kBand{[](double x) { return x >= 1e-12 && x <= 180; },
                           "an angle in degrees from 1e-12 to 180"};

/// The values of `mechanism.type` of a dwell.
std::vector<std::string_view> dwell_types() {
  std::vector<std::string_view> words;
  for (const TopologyWord& topology : function_topology_words()) words.push_back(topology.word);
  words.push_back(kChainWord);
  return words;
}

std::optional<double> in_radians(const std::optional<double>& degrees) {
  return degrees ? std::optional(radians(*degrees)) : std::nullopt;
}

/// An output under `key`, a length, or in degrees under its name of angles.
std::optional<double> read_output_amount(TableReader& table, bool slides, std::string_view length,
                                         std::string_view angle, const NumberRule& angles) {
  return slides ? table.number(length, kErrorScale) : in_radians(table.number(angle, angles));
}

Dwell read_dwell(TableReader& table, bool slides) {
  constexpr std::string_view kOver = "over_deg";
  Dwell dwell;
  if (!table.has(kOver)) {
    table.fault(kOver, "is missing; expected the angle of the crank over which the output stands");
  }
  dwell.over = radians(table.number(kOver, kPartOfTurn).value_or(0));
  dwell.from = in_radians(table.number("from_deg", kAngle));
  dwell.half_band_max =
      read_output_amount(table, slides, "half_band_max", "half_band_deg_max", kBand);
  table.finish();
  return dwell;
}

/// Whether two dwells whose places are given share a part of the turn.
bool overlap(const Dwell& a, const Dwell& b) {
  if (!a.from || !b.from) return false;
  constexpr double kTouching = 1e-9;
  const auto after = [](double from, double to) {
    const double way = std::fmod(to - from, kTurn);
    return way < 0 ? way + kTurn : way;
  };
  return after(*a.from, *b.from) < a.over - kTouching ||
         after(*b.from, *a.from) < b.over - kTouching;
}

void read_apart(TableReader& target, DwellProblem& problem) {
  const std::string_view key = slides(problem) ? "apart" : "apart_deg";
  problem.apart = read_output_amount(target, slides(problem), key, key, kPartOfTurn);
  const bool two = problem.dwells.size() == 2;
  if (target.has(key) && !two) {
    target.fault(key, "is given with one dwell; remove it, or give two");
  } else if (two && !target.has(key)) {
    target.fault(key,
                 "is missing; expected by how much the output differs between the two dwells, "
                 "which could be one without it");
  }
}

void check_dwells(TableReader& target, const DwellProblem& problem) {
  if (problem.dwells.size() != 2) return;
  const auto& [first, second] = std::tie(problem.dwells[0], problem.dwells[1]);
  if (first.over + second.over >= kTurn) {
    target.fault(kDwell, fmt::format("takes {:.6g} degrees of the crank's turn together; expected "
                                     "less than 360",
                                     (first.over + second.over) * 180 / kPi));
  } else if (overlap(first, second)) {
    target.fault(kDwell,
                 "has two dwells that overlap; expected a second one that begins after the "
                 "end of the first");
  }
}

void read_dwell_target(TableReader& target, DwellProblem& problem) {
  const bool is_slider = slides(problem);
  for (TableReader& table : target.tables(kDwell, {1, 2, "dwells"})) {
    problem.dwells.push_back(read_dwell(table, is_slider));
  }
  check_dwells(target, problem);
  read_apart(target, problem);
  constexpr std::string_view kStroke = "stroke_min";
  problem.swing_min =
      read_output_amount(target, is_slider, kStroke, "swing_deg_min", kPartOfTurn).value_or(0);
  if (is_slider && !target.has(kStroke)) {
    target.fault(kStroke,
                 "is missing; expected the least stroke of the slider, which says how large the "
                 "mechanism is");
  }
}

Wanted wanted_output(const DwellProblem& problem) {
  const auto& [from, to] = problem.output;
  if (slides(problem)) return {kOutput, {to}, true};
  return {kOutput, {from, to}};
}

void read_dwell_constraints(TableReader& constraints, DwellConstraints& limits) {
  limits.transmission_angle =
      read_chain_transmission(constraints).value_or(limits.transmission_angle);
  refuse_four_bar_limits(constraints, "transmission_angle_deg");
}

}  // namespace
}  // namespace reading

bool slides(const DwellProblem& problem) {
  return problem.output[0] == guide_name(problem.output[1]);
}

bool KindTraits<DwellProblem>::takes(reading::TableReader& document) {
  return document.has_table("target") && document.table("target").contains(reading::kDwell);
}

DwellProblem KindTraits<DwellProblem>::read(reading::TableReader& document,
                                            const std::filesystem::path& /*folder*/) {
  using namespace reading;
  DwellProblem problem;
  LinkageTables tables(document);
  if (tables.mechanism.has("type")) {
    problem.mechanism = tables.mechanism.text("type").value_or("");
    if (std::ranges::count(dwell_types(), problem.mechanism) == 0) {
      fault_chain_type(document, tables.mechanism, dwell_types());
      return problem;
    }
  }
  const auto known = function_topologies(problem.mechanism);
  problem.output = read_output(tables.target, problem.mechanism, known);
  read_dwell_target(tables.target, problem);
  problem.topologies = read_topologies(document, tables, known, wanted_output(problem));
  read_dwell_constraints(tables.constraints, problem.constraints);
  read_chain_solve(tables.solve, problem.solve);
  if (std::ranges::none_of(problem.topologies, has_three_pin_link)) {
    read_dwell_raster(document, problem);
  }
  problem.against =
      read_against(tables.solve,
                   {.mechanism = problem.mechanism,
                    .topologies = problem.topologies,
                    .of_any_count = {},
                    .has_sizes = slides(problem),
                    .is_given = is_given(problem),
                    .refusal = problem.raster ? "is given with a raster; remove one of them" : ""},
                   problem.solve);
  read_made(document, tables, slides(problem) ? "length" : "deg", LimitSpan::turn, problem);
  for (TableReader* table :
       {&tables.target, &tables.mechanism, &tables.constraints, &tables.solve}) {
    table->finish();
  }
  problem.warnings = read_warnings(document);
  return problem;
}

}  // namespace cognate::problems
