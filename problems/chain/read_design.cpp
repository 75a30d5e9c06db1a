#include "problems/chain/read_design.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "problems/linkage/keys.hpp"
#include "problems/linkage/read_constraints.hpp"
#include "problems/mechanism/part_names.hpp"
#include "problems/toml/nearest.hpp"

namespace cognate::problems::reading {
namespace {

constexpr double kQuarterTurn = 90;
constexpr std::string_view kOutput = "output";

/// Faults a key that is given; only now it is known, as messages offer the keys that are.
void refuse(TableReader& table, std::string_view key, std::string_view why) {
  if (!table.contains(key)) return;
  table.know({key});
  table.fault(key, why);
}

}  // namespace

std::vector<Topology> read_topologies(TableReader& document, LinkageTables& tables,
                                      std::vector<Topology> known, const Wanted& wanted) {
  PartTables parts(document, tables.mechanism);
  const bool is_defined_here = known.empty();
  std::vector<Topology> all = std::move(known);
  if (is_defined_here) {
    auto topology = read_structure(parts, tables.mechanism, tables.target, wanted);
    if (topology) all.push_back(*std::move(topology));
  }
  if (!all.empty()) read_chain_bounds(tables.bounds, all);
  is_defined_here ? read_given(parts, all) : read_given_by_name(parts, all);
  if (!all.empty()) tables.bounds.finish();
  return all;
}

Wanted read_traced(TableReader& target, const std::string& type, std::string_view traced) {
  Wanted wanted{"point", {}};
  if (!target.has(wanted.key)) return wanted;
  if (type != kChainWord) {
    target.fault(wanted.key, fmt::format("is given with mechanism.type = {}, whose point {} is "
                                         "traced; remove it, or take type = \"chain\"",
                                         in_quotes(type), traced));
  } else if (const auto name = read_name(target, wanted.key)) {
    wanted.points = {*name};
  }
  return wanted;
}

std::array<std::string, 2> read_output(TableReader& target, const std::string& type,
                                       const std::vector<Topology>& known) {
  const bool slides = !known.empty() && ends_in_slider(known.front());
  if (!slides && !target.has_text(kOutput)) return read_output_link(target, type);
  const std::string usual = slides ? known.front().lines.back().name : "";
  const std::string pin = target.has(kOutput) ? read_name(target, kOutput).value_or(usual) : usual;
  if (!known.empty() && pin != usual) {
    target.fault(
        kOutput,
        fmt::format("is {}, but the output of type = {} is {}; remove it, or take "
                    "type = \"chain\"",
                    in_quotes(pin), in_quotes(type),
                    slides ? "the slider " + in_quotes(usual) : "the link [\"G\", \"F\"]"));
  }
  return {guide_name(pin), pin};
}

std::array<std::string, 2> read_output_link(TableReader& target, const std::string& type) {
  std::array<std::string, 2> usual{"G", "F"};
  const auto names = target.texts(kOutput, {2, 2, "names of points"});
  if (!names) return usual;
  for (std::size_t i = 0; i < 2; ++i) {
    if (!check_name(target, target.where(kOutput, i), target.name(kOutput), (*names)[i])) {
      return usual;
    }
  }
  const std::array<std::string, 2> given{(*names)[0], (*names)[1]};
  if (type == kChainWord || given == usual) return given;
  target.fault(kOutput, fmt::format("is [\"{}\", \"{}\"], but the output of type = {} is the "
                                    "link [\"G\", \"F\"]; remove it, or take type = \"chain\"",
                                    given[0], given[1], in_quotes(type)));
  return given;
}

std::optional<Range> read_chain_transmission(TableReader& constraints) {
  constexpr std::string_view kKey = "transmission_angle_deg";
  const auto range = constraints.range(kKey, kTransmissionAngle);
  if (!range) return std::nullopt;
  if (std::max(range->min, 2 * kQuarterTurn - range->max) >= kQuarterTurn) {
    constraints.fault(
        kKey, fmt::format("is [{}, {}], which no dyad satisfies in motion; expected min < 90 < max",
                          range->min, range->max));
    return std::nullopt;
  }
  return Range{radians(range->min), radians(range->max)};
}

void refuse_four_bar_limits(TableReader& constraints, std::string_view taken) {
  for (const std::string_view key :
       {"class", "link_ratio_max", "time_ratio", "pivot_region", "clearance", "no_branch_defect",
        "no_order_defect", "no_circuit_defect", "no_extra_loop"}) {
    refuse(constraints, key,
           fmt::format("is a limit of four-bars; remove it: chains take {}", taken));
  }
}

ChainConstraints read_chain_constraints(TableReader& constraints) {
  ChainConstraints limits;
  limits.transmission_angle =
      read_chain_transmission(constraints).value_or(limits.transmission_angle);
  limits.over = constraints.choice<LimitSpan>("over").value_or(limits.over);
  limits.rms_error_max = constraints.number("rms_error_max", kErrorScale);
  refuse_four_bar_limits(constraints, "transmission_angle_deg, over and rms_error_max");
  return limits;
}

void refuse_with_three_pins(TableReader& document, LinkageTables& tables, LimitSpan over) {
  constexpr std::string_view kWhy =
      "is for chains of dyads alone, not for links with three pins; remove it";
  for (const std::string_view key : {"layers", "raster", "tolerance"}) refuse(document, key, kWhy);
  refuse(tables.solve, "robust", kWhy);
  refuse(tables.constraints, "layers_max", kWhy);
  if (over == LimitSpan::turn) return;
  refuse(tables.constraints, "over",
         "is \"range\", but the crank of a mechanism with a three-pin link turns fully; remove it");
}

void read_chain_solve(TableReader& table, Solve& solve) {
  solve.starts = table.integer("starts", kStartCount.min, kStartCount.max);
  read_design_count(table, kMostSearchedDesigns, solve);
  for (const std::string_view key :
       {"solver", "tolerance", "loss", "loss_scale", "certify", "certify_gap", "atlas"}) {
    refuse(table, key,
           "is for four-bars alone; remove it: the search of a chain takes starts and designs");
  }
}

void fault_chain_type(TableReader& document, TableReader& mechanism,
                      std::span<const std::string_view> types) {
  mechanism.choice_of("type", types);
  document.know({"target", "mechanism", "bounds", "constraints", "solve", "warnings", "pivot",
                 "crank", "dyad", "point", "layers", "raster", "tolerance"});
}

}  // namespace cognate::problems::reading
