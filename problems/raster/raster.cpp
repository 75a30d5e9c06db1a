#include "problems/raster/raster.hpp"

#include <algorithm>
#include <cmath>

namespace cognate::problems {

const RasterRule* Raster::rule(std::string_view key, std::string_view group) const {
  for (const std::string_view name : {key, group, std::string_view("length")}) {
    const auto found = std::ranges::find(
        rules, name, [](const auto& entry) { return std::string_view(entry.first); });
    if (found == rules.end()) continue;
    return found->second.is_free() ? nullptr : &found->second;
  }
  return nullptr;
}

bool Raster::has(std::string_view key) const {
  return std::ranges::any_of(rules, [&](const auto& entry) { return entry.first == key; });
}

synthesis::RasterValues values_within(const RasterRule& rule, const Range& range,
                                      const Range& reach) {
  const double lower = std::isfinite(range.min) ? range.min : reach.min;
  const double upper = std::isfinite(range.max) ? range.max : reach.max;
  return rule.step ? synthesis::RasterValues::multiples(*rule.step, lower, upper)
                   : synthesis::RasterValues::list(rule.values, lower, upper);
}

}  // namespace cognate::problems
