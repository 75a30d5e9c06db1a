/// @file What the searches of the page that one draws on have in common.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "problems/linkage/result.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::page {

/// Longer lists are not drawn by hand.
inline constexpr std::size_t kMostTargets = 200;

/// A problem as the page asks it.
struct SketchQuestion {
  const problems::reading::Table& document;
  std::uint64_t seed = 1;
};

/// `known`, designs with which the search begins: rows of the fixed pivots, the lengths of crank,
/// coupler and rocker, the coupler point, 1 where the assembly is open, the guided body's angle in
/// the coupler in degrees, and the crank's angle at each of `targets` targets, in degrees.
std::vector<problems::Design> read_known(problems::reading::TableReader& document,
                                         std::size_t targets);

/// A problem, and designs with which its search begins.
template <class Problem>
struct Sketched {
  Problem problem;
  std::vector<problems::Design> known;
};

/// A search on the one thread of a page.
problems::Run run_of(const SketchQuestion& question, std::vector<problems::Design> known);

/// A design with its errors and what is measured of it.
nlohmann::ordered_json sketched(const problems::Design& design);

/// Whether a target is given: without one there is nothing to search for.
bool has_target(problems::reading::TableReader& target, std::string_view key);

/// The answers: `status` and `designs`, or `faults`, a list of sentences.
nlohmann::ordered_json sketched_paths(const SketchQuestion& question);
nlohmann::ordered_json sketched_motions(const SketchQuestion& question);

}  // namespace cognate::page
