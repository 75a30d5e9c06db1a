#include "app/console/table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>
#include <utility>

#include "app/console/design_columns.hpp"
#include "app/console/layers_table.hpp"
#include "app/console/messages.hpp"
#include "app/console/paint.hpp"
#include "app/console/table_text.hpp"
#include "app/console/text_table.hpp"
#include "app/console/tolerance_table.hpp"
#include "problems/basics/names.hpp"

namespace cognate::app {
namespace {

using problems::Result;

/// Quantities whose names in files say less than words can.
constexpr std::pair<std::string_view, const char*> kWords[] = {
    {"best_hits", "runs that reached the best"},
    {"chance_of_unseen_minimum", "estimated probability of a better minimum"}};

/// A name as words: "complex_solutions" is "complex solutions", "real.triplets" "real triplets".
std::string words(std::string name) {
  for (const auto& [key, text] : kWords) {
    if (name == key) return text;
  }
  std::ranges::replace_if(
      name, [](char c) { return c == '_' || c == '.'; }, ' ');
  return printable(name);
}

/// The quantities of the synthesis as a whole on one line; empty without quantities.
std::string quantities_line(const Result& result) {
  std::string line;
  for (const auto& quantity : result.quantities) {
    const auto* number = std::get_if<double>(&quantity.value);
    if (number != nullptr && !std::isfinite(*number)) continue;
    if (!line.empty()) line += "; ";
    line += words(quantity.name) + ": " + std::visit(WrittenValue{}, quantity.value);
  }
  return line.empty() ? line : line + '\n';
}

/// What is proved of the best design.
std::string certificate_line(const Result& result) {
  if (!result.certificate) return {};
  const problems::Certificate& proof = *result.certificate;
  const std::string among = fmt::format("among {} ({} boxes)", proof.domain, proof.boxes);
  if (proof.complete) {
    return fmt::format(
        "certified: sum of squares {:.10g} is within {:.2g} % of the minimum, at least {:.10g}, "
        "{}\n",
        proof.upper_bound, 100 * proof.gap_relative, proof.lower_bound, among);
  }
  return fmt::format(
      "not certified in the time given: sum of squares {:.10g}, its minimum at least {:.10g} "
      "(gap {:.2g} %), {}\n",
      proof.upper_bound, proof.lower_bound, 100 * proof.gap_relative, among);
}

/// Of the best design: those of the others are in the result.
std::string tolerances_text(std::span<const problems::Design> designs, const Screen& screen) {
  if (designs.empty() || !designs.front().tolerance) return {};
  return tolerance_table(*designs.front().tolerance, screen);
}

std::string layers_text(std::span<const problems::Design> designs, const Screen& screen) {
  if (designs.empty() || !designs.front().layers) return {};
  const auto& drive = designs.front().mechanism.mechanism.drive;
  return layers_table(*designs.front().layers, driven_by_length(drive), screen);
}

/// Without a unit in the file lengths count as metres where powers, torques and inertias follow
/// from them.
Screen with_metres(Screen screen, std::span<const problems::Design> designs) {
  const auto has_unit = [](const problems::Design& design) {
    return design.metrics.cycle.any([](const auto& quantity) { return quantity.is_in_metres(); });
  };
  if (screen.length.empty() && std::ranges::any_of(designs, has_unit)) screen.length = "m";
  return screen;
}

}  // namespace

std::string design_table(const std::string& heading, const ColumnChoice& choice,
                         const Result& result, const Screen& screen) {
  const auto designs = shown_designs(result);
  return result_table({.heading = heading,
                       .designs = designs.empty() ? ""
                                                  : table_text(design_columns(designs, choice),
                                                               with_metres(screen, designs)),
                       .after = quantities_line(result) + tolerances_text(designs, screen) +
                                layers_text(designs, screen) + certificate_line(result)},
                      result, screen);
}

}  // namespace cognate::app
