#include "app/studio/templates.hpp"

#include <algorithm>

#include "app/commands/starters.hpp"

namespace cognate::app {
namespace {

constexpr std::string_view kNew = "new/";

/// What the line `title = "…"` says.
std::string_view title_in(std::string_view text) {
  constexpr std::string_view kBegin = "\ntitle = \"";
  const auto at = text.find(kBegin);
  if (at == std::string_view::npos) return {};
  const auto from = at + kBegin.size();
  return text.substr(from, text.find('"', from) - from);
}

/// A study names another file.
bool stands_alone(const Starter& starter) {
  return starter.kind != "study";
}

}  // namespace

std::vector<Template> templates() {
  std::vector<Template> all;
  for (const Starter& starter : starters()) {
    if (!stands_alone(starter)) continue;
    all.push_back({std::string(kNew).append(starter.kind), title_in(starter.text)});
  }
  for (const auto& problem : worked_problems()) {
    all.push_back({std::string(problem.name), title_in(problem.text)});
  }
  return all;
}

std::optional<std::string_view> template_text(std::string_view name) {
  if (name.starts_with(kNew)) {
    const auto kind = name.substr(kNew.size());
    const auto found = std::ranges::find(starters(), kind, &Starter::kind);
    if (found == starters().end() || !stands_alone(*found)) return std::nullopt;
    return found->text;
  }
  const auto found = std::ranges::find(worked_problems(), name, &WorkedProblem::name);
  if (found == worked_problems().end()) return std::nullopt;
  return found->text;
}

}  // namespace cognate::app
