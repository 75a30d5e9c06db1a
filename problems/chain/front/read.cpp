#include "problems/chain/front/read.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <vector>

#include "problems/search/read_objectives.hpp"
#include "problems/toml/nearest.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::string_view kKey = "objectives", kDesigns = "designs", kError = "error";

/// The measure beside the error; none where there is none, or with a fault.
std::optional<ChainMeasure> read_measure(TableReader& solve) {
  std::vector<std::string_view> allowed{kError};
  for (const auto& named : names<ChainMeasure>()) allowed.push_back(named.name);
  const auto words = solve.texts(kKey, {1, 2, "objectives"});
  if (!words) return std::nullopt;
  std::optional<ChainMeasure> measure;
  for (std::size_t i = 0; i < words->size(); ++i) {
    const std::string& word = (*words)[i];
    const auto own = from_string<ChainMeasure>(word);
    if (own) measure = own;
    if (own || word == kError) continue;
    solve.faults().add(solve.where(kKey, i),
                       fmt::format("solve.objectives has {}; allowed of chains are {}",
                                   in_quotes(word), quoted_list(allowed)));
    return std::nullopt;
  }
  if (*words == std::vector{std::string(kError)}) return std::nullopt;
  if (measure && std::ranges::count(*words, kError) == 1) return measure;
  solve.fault(kKey, "is not the error and one other; expected \"error\" and one other objective");
  return std::nullopt;
}

bool is_of_one_count(const std::vector<Topology>& topologies) {
  return std::ranges::all_of(topologies, [&](const Topology& one) {
    return link_count(one) == link_count(topologies.front());
  });
}

void check_links(TableReader& solve, const FrontScope& scope) {
  if (is_of_one_count(scope.topologies)) {
    solve.fault(kKey, fmt::format("has \"links\", but every chain of type = {} has {} links; {}",
                                  in_quotes(scope.mechanism), link_count(scope.topologies.front()),
                                  scope.of_any_count.empty()
                                      ? "expected another objective"
                                      : fmt::format("expected type = \"{}\"", scope.of_any_count)));
  }
  if (solve.has(kDesigns)) {
    solve.fault(kDesigns,
                "is given with the objective \"links\", which gives one design for each "
                "number of links; remove it");
  }
}

}  // namespace

std::optional<ChainMeasure> read_against(TableReader& solve_table, const FrontScope& scope,
                                         Solve& solve) {
  const auto against = read_measure(solve_table);
  if (!against || scope.topologies.empty()) return against;
  if (!scope.refusal.empty()) solve_table.fault(kKey, scope.refusal);
  if (scope.is_given) {
    solve_table.fault(kKey,
                      "is given with a chain of which every dimension is given; remove it, or "
                      "leave dimensions open");
  }
  if (against == ChainMeasure::size && !scope.has_sizes) {
    solve_table.fault(kKey,
                      "has \"size\", but a mechanism of any size generates these angles; expected "
                      "\"transmission_angle\"");
  }
  if (against == ChainMeasure::links) {
    check_links(solve_table, scope);
  } else {
    read_front_designs(solve_table, solve);
  }
  return against;
}

}  // namespace cognate::problems::reading
