#include "problems/evaluation/read_output.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <vector>

#include "problems/toml/nearest.hpp"

namespace cognate::problems::reading {
namespace {

struct OutputWord {
  std::string_view key;
  bool AnalysisOutput::*wanted;
};

constexpr OutputWord kOutputWords[] = {{"position", &AnalysisOutput::position},
                                       {"velocity", &AnalysisOutput::velocity},
                                       {"acceleration", &AnalysisOutput::acceleration},
                                       {"transmission", &AnalysisOutput::transmission},
                                       {"curvature", &AnalysisOutput::curvature},
                                       {"reactions", &AnalysisOutput::reactions},
                                       {"torque", &AnalysisOutput::torque}};

constexpr std::string_view kWant = "want";
constexpr std::string_view kPoints = "points";
constexpr std::string_view kInstantGeometry = "instant_geometry";
constexpr std::string_view kFoot = "foot", kFootDuty = "duty";

void add_point_wanted(const PartNames& names, const Mention& mention, AnalysisOutput& output,
                      FaultList& faults) {
  const auto point = find_point(names, mention, faults);
  if (!point) return;
  const int index = static_cast<int>(*point);
  if (std::ranges::find(output.points, index) == output.points.end()) {
    output.points.push_back(index);
  }
}

const OutputWord* find_output_word(std::string_view word) {
  const auto* const found = std::ranges::find(kOutputWords, word, &OutputWord::key);
  return found == std::end(kOutputWords) ? nullptr : found;
}

// A word of `want` that is neither a quantity nor a point.
void fault_word(const PartNames& names, const Mention& mention, FaultList& faults) {
  if (fault_briefly(mention, faults)) return;
  std::vector<std::string_view> known;
  for (const OutputWord& quantity : kOutputWords) known.push_back(quantity.key);
  const std::string allowed = quoted_list(known);
  const std::string points = point_list(names);
  std::ranges::copy(names.all_points(), std::back_inserter(known));
  const auto meant = nearest(mention.name, known);
  faults.add(mention.where,
             fmt::format("{} has {}{}; allowed are {} and the points {}", mention.called,
                         in_quotes(mention.name), meant ? ", perhaps for " + in_quotes(*meant) : "",
                         allowed, points));
}

void read_wanted(TableReader& table, const PartNames& names, AnalysisOutput& output) {
  const auto wanted = read_mentions(table, kWant, {1, 10000, "words"});
  if (!wanted) return;
  const bool quantities = std::ranges::any_of(
      *wanted, [](const Mention& mention) { return find_output_word(mention.name) != nullptr; });
  for (const OutputWord& quantity : kOutputWords) {
    if (quantities) output.*quantity.wanted = false;
  }
  for (const Mention& mention : *wanted) {
    if (const auto* quantity = find_output_word(mention.name)) {
      output.*quantity->wanted = true;
    } else if (names.is_announced(mention.name)) {
      add_point_wanted(names, mention, output, table.faults());
    } else {
      fault_word(names, mention, table.faults());
    }
  }
}

void read_instant_geometry(TableReader& table, const PartNames& names, AnalysisOutput& output) {
  const auto bodies = read_mentions(table, kInstantGeometry, {1, 10000, "bodies"});
  for (const Mention& mention : bodies.value_or(std::vector<Mention>{})) {
    const auto body = find_body(names, mention, table.faults());
    if (!body) continue;
    if (*body == 0) {
      table.faults().add(mention.where,
                         fmt::format("{} has \"frame\", which does not move; expected a "
                                     "moving body",
                                     mention.called));
    } else if (std::ranges::find(output.instant_geometry, *body) == output.instant_geometry.end()) {
      output.instant_geometry.push_back(*body);
    }
  }
}

/// The point whose gait is measured, of a link that a crank moves.
void read_foot(TableReader& table, const PartNames& names, bool slides, AnalysisOutput& output) {
  output.duty = table.number(kFootDuty, kDutyFactor);
  if (!table.has(kFoot)) {
    if (!table.has(kFootDuty)) return;
    return table.fault(kFootDuty, "is given without foot; remove it, or give the name of a point");
  }
  const auto foot = read_mention(table, kFoot);
  if (!foot) return;
  const auto point = find_point(names, *foot, table.faults());
  if (!point) return;
  const bool is_fixed = names.parts().points[*point].on.front().body == 0;
  if (is_fixed || slides) {
    return table.fault(kFoot, is_fixed ? "is a point of the frame; expected one of a moving link"
                                       : "is given with a driving slider; expected a crank, whose "
                                         "turn is a step");
  }
  output.foot = static_cast<int>(*point);
}

void read_keys(TableReader& table, AnalysisOutput& output) {
  for (const OutputWord& quantity : kOutputWords) {
    output.*quantity.wanted = table.boolean(quantity.key).value_or(output.*quantity.wanted);
    if (!table.has(kWant) || !table.has(quantity.key)) continue;
    table.fault(quantity.key, fmt::format("is given beside output.{0}; give {0} = [...] or a key "
                                          "for each quantity",
                                          kWant));
  }
}

}  // namespace

AnalysisOutput read_output(TableReader& table, const PartNames& names, bool forces, bool slides) {
  AnalysisOutput output;
  output.reactions = forces;
  output.torque = forces;
  read_keys(table, output);
  read_wanted(table, names, output);
  const auto points = read_mentions(table, kPoints, {1, 10000, "points"});
  for (const Mention& mention : points.value_or(std::vector<Mention>{})) {
    add_point_wanted(names, mention, output, table.faults());
  }
  read_instant_geometry(table, names, output);
  read_foot(table, names, slides, output);
  output.cognates = table.boolean(kCognates).value_or(false);
  output.curve = table.boolean(kCurve).value_or(false);
  const bool any = std::ranges::any_of(
      kOutputWords, [&](const OutputWord& quantity) { return output.*quantity.wanted; });
  const bool other = table.has(kInstantGeometry) || table.has(kFoot);
  if (!any && !other && !output.cognates && !output.curve) {
    table.faults().add(table.where(), "[output] is empty; expected at least one quantity");
  }
  table.finish();
  return output;
}

}  // namespace cognate::problems::reading
