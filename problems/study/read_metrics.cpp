#include "problems/study/read_metrics.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <vector>

#include "problems/study/key_path.hpp"
#include "problems/toml/nearest.hpp"

namespace cognate::problems::reading {
namespace {

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

}  // namespace

StudyNames::StudyNames(const BaseFile* base, const Study& study) : base_(base), study_(&study) {}

bool StudyNames::is_varied(std::string_view name) const {
  return std::ranges::find(study_->variables, name, &StudyVariable::key) != study_->variables.end();
}

std::optional<NameKind> StudyNames::find(std::string_view name) const {
  if (!base_) return NameKind::either;
  if (is_varied(name)) return NameKind::number;
  const auto& [names, openings] = base_->metrics;
  const auto found = std::ranges::find(names, name, &MetricName::name);
  if (found != names.end()) return found->word ? NameKind::word : NameKind::number;
  const bool opened = std::ranges::any_of(openings, [&](std::string_view opening) {
    return name == opening || (name.starts_with(opening) &&
                               (name[opening.size()] == '.' || name[opening.size()] == '['));
  });
  return opened && parse_key_path(name) ? std::optional(NameKind::either) : std::nullopt;
}

std::optional<std::string> StudyNames::namesake(std::string_view name) const {
  auto columns = study_columns(*study_);
  for (const auto& objective : study_->objectives) columns.push_back(objective.name);
  for (const auto& column : columns) {
    if (column != name && std::ranges::equal(column, name, {}, lower, lower)) return column;
  }
  return std::nullopt;
}

std::string StudyNames::hint(std::string_view name) const {
  std::vector<std::string_view> known;
  for (const auto& metric : base_->metrics.names) known.push_back(metric.name);
  for (const auto& opening : base_->metrics.openings) known.push_back(opening);
  for (const auto& variable : study_->variables) known.push_back(variable.key);
  const auto meant = nearest(name, known);
  return meant ? fmt::format("did you mean {}?", in_quotes(*meant))
               : "'cognate list --metrics' names all";
}

}  // namespace cognate::problems::reading
