#include "problems/evaluation/layer_figures.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <utility>

#include "problems/basics/degrees.hpp"
#include "problems/layers/assign.hpp"

namespace cognate::problems {
namespace {

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += (i == 0 ? "" : i + 1 < names.size() ? ", " : " and ") + names[i];
  }
  return text;
}

std::string place(const AnalysisProblem& problem, double drive) {
  return drive_slides(problem) ? fmt::format("{:.6g}", drive)
                               : fmt::format("{:.6g} deg", degrees(drive) + 0.0);
}

bool is_blocked(const LayerResult& layers, const std::string& link) {
  return std::ranges::find(layers.blocked, link) != layers.blocked.end();
}

/// Why there are no layers: which pins cannot pass which of the links in question.
std::string blocked_note(const AnalysisProblem& problem, const LayerResult& layers) {
  std::string why;
  for (const LayerConflict& conflict : layers.conflicts) {
    if (!conflict.first_is_pin || !conflict.drive) continue;
    const auto pin = std::ranges::find(layers.pins, conflict.first, &LayerResult::Pin::name);
    const bool of_these = std::ranges::any_of(
        pin->joins, [&](const std::string& link) { return is_blocked(layers, link); });
    if (!of_these || (!conflict.second_is_pin && !is_blocked(layers, conflict.second))) continue;
    why += fmt::format("{}the pin {} meets {}{} at {}", why.empty() ? ": " : ", ", conflict.first,
                       conflict.second_is_pin ? "the pin " : "", conflict.second,
                       place(problem, *conflict.drive));
  }
  return fmt::format("no number of layers suffices: {} block each other in every order{}",
                     joined(layers.blocked), why);
}

/// Collisions that could not be decided count as collisions.
std::string unresolved_note(const AnalysisProblem& problem, const LayerResult& layers) {
  std::string text;
  for (const LayerConflict& conflict : layers.conflicts) {
    if (conflict.kind != LayerConflictKind::unresolved) continue;
    text += fmt::format("{}{}{} and {}{} at {}", text.empty() ? "" : ", ",
                        conflict.first_is_pin ? "the pin " : "", conflict.first,
                        conflict.second_is_pin ? "the pin " : "", conflict.second,
                        place(problem, *conflict.drive));
  }
  return text.empty() ? text
                      : "parts that come so near that it cannot be decided whether they collide "
                        "are kept in different layers: " +
                            text;
}

}  // namespace

void add_layers(const AnalysisProblem& problem, const AssemblyRanges& motion,
                const Deadline& deadline, AnalysisResult& result) {
  if (!problem.layers) return;
  if (motion.runs.empty()) {
    result.notes.emplace_back("the links have no layers: the mechanism can be assembled nowhere");
    return;
  }
  auto layers =
      assign_layers(problem.mechanism, motion, *problem.layers, [&] { return deadline.reached(); });
  if (!layers) {
    result.notes.push_back(layers.error());
    return;
  }
  if (layers->count) {
    result.quantities.push_back({"layers.count", static_cast<double>(*layers->count)});
    double crossings = 0;
    for (const auto& pin : layers->pins) crossings += static_cast<double>(pin.crosses.size());
    result.quantities.push_back({"layers.pin_crossings", crossings});
  } else {
    result.notes.push_back(blocked_note(problem, *layers));
  }
  if (auto note = unresolved_note(problem, *layers); !note.empty()) {
    result.notes.push_back(std::move(note));
  }
  result.layers = *std::move(layers);
}

}  // namespace cognate::problems
