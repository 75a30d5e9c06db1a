#include "problems/layers/notes.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "problems/basics/degrees.hpp"
#include "problems/basics/enumeration.hpp"

namespace cognate::problems {
namespace {

std::string drive_text(double drive, bool slides) {
  return slides ? fmt::format("{:.6g}", drive) : fmt::format("{:.6g} deg", degrees(drive) + 0.0);
}

std::string part_text(const std::string& name, bool is_pin) {
  return (is_pin ? "the pin " : "") + name;
}

bool is_blocked(const LayerResult& layers, const std::string& link) {
  return std::ranges::find(layers.blocked, link) != layers.blocked.end();
}

}  // namespace

std::string blocked_note(const LayerResult& layers, bool drive_slides) {
  std::string why;
  for (const LayerConflict& conflict : layers.conflicts) {
    if (!conflict.first_is_pin || !conflict.drive) continue;
    const auto pin = std::ranges::find(layers.pins, conflict.first, &LayerResult::Pin::name);
    const bool of_these = std::ranges::any_of(
        pin->joins, [&](const std::string& link) { return is_blocked(layers, link); });
    if (!of_these || (!conflict.second_is_pin && !is_blocked(layers, conflict.second))) continue;
    why += fmt::format("{}the pin {} meets {} at {}", why.empty() ? ": " : ", ", conflict.first,
                       part_text(conflict.second, conflict.second_is_pin),
                       drive_text(*conflict.drive, drive_slides));
  }
  return fmt::format("no number of layers suffices: {} block each other in every order{}",
                     enumeration(layers.blocked), why);
}

std::string unresolved_note(const LayerResult& layers, bool drive_slides) {
  std::string text;
  for (const LayerConflict& conflict : layers.conflicts) {
    if (conflict.kind != LayerConflictKind::unresolved) continue;
    text += fmt::format("{}{} and {} at {}", text.empty() ? "" : ", ",
                        part_text(conflict.first, conflict.first_is_pin),
                        part_text(conflict.second, conflict.second_is_pin),
                        drive_text(*conflict.drive, drive_slides));
  }
  return text.empty() ? text
                      : "parts that come so near that it cannot be decided whether they collide "
                        "are kept in different layers: " +
                            text;
}

std::string collisions_text(const LayerResult& layers, bool drive_slides) {
  constexpr std::size_t kShown = 4;
  std::vector<std::string> all;
  for (const LayerConflict& conflict : layers.conflicts) {
    if (!conflict.drive) continue;
    all.push_back(fmt::format("{} and {} at {}", part_text(conflict.first, conflict.first_is_pin),
                              part_text(conflict.second, conflict.second_is_pin),
                              drive_text(*conflict.drive, drive_slides)));
  }
  if (all.size() > kShown) all.resize(kShown);
  std::string text;
  for (const std::string& one : all) text += (text.empty() ? "" : ", ") + one;
  return text;
}

}  // namespace cognate::problems
