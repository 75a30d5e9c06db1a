#include "app/study/study_words.hpp"

#include <algorithm>
#include <array>

namespace cognate::app {
namespace {

/// In the order of the enumeration.
constexpr std::array<std::string_view, 5> kNames = {"solved", "infeasible", "no-solution",
                                                    "invalid", "filtered"};

}  // namespace

std::string_view run_status_name(problems::RunStatus status) {
  return kNames[static_cast<std::size_t>(status)];
}

std::optional<problems::RunStatus> run_status(std::string_view name) {
  const auto* found = std::ranges::find(kNames, name);
  if (found == kNames.end()) return std::nullopt;
  return static_cast<problems::RunStatus>(found - kNames.begin());
}

}  // namespace cognate::app
