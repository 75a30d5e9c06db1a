#include "problems/chain/front/read.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <vector>

#include "problems/chain/given.hpp"
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

/// What the measure does not go with.
std::string_view refusal(const ChainPathProblem& problem) {
  if (problem.raster) return "is given with a raster; remove one of them";
  if (problem.solve.robust) return "is given with robust; remove one of them";
  if (is_given(problem)) {
    return "is given with a chain of which every dimension is given; remove it, or leave "
           "dimensions open";
  }
  return {};
}

bool is_of_one_count(const std::vector<Topology>& topologies) {
  return std::ranges::all_of(topologies, [&](const Topology& one) {
    return link_count(one) == link_count(topologies.front());
  });
}

}  // namespace

void read_against(TableReader& solve, ChainPathProblem& problem) {
  problem.against = read_measure(solve);
  if (!problem.against || problem.topologies.empty()) return;
  if (const auto why = refusal(problem); !why.empty()) solve.fault(kKey, why);
  if (problem.against != ChainMeasure::links) {
    read_front_designs(solve, problem.solve);
    return;
  }
  if (is_of_one_count(problem.topologies)) {
    solve.fault(kKey,
                fmt::format("has \"links\", but every chain of type = {} has {} links; "
                            "expected type = \"any\"",
                            in_quotes(problem.mechanism), link_count(problem.topologies.front())));
  }
  if (solve.has(kDesigns)) {
    solve.fault(kDesigns,
                "is given with the objective \"links\", which gives one design for each "
                "number of links; remove it");
  }
}

}  // namespace cognate::problems::reading
