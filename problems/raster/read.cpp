#include "problems/raster/read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "problems/raster/keys.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::string_view kTable = "raster";
/// Beyond so many values one list is no raster that anything is bought or drilled by.
constexpr Count kListed{.min = 1, .max = 10000, .of = "values"};
/// How far a raster reaches where nothing bounds it, in steps.
constexpr double kReach = 1e12;

std::optional<RasterRule> read_rule(TableReader& table, const RasterKey& key) {
  if (table.has_array(key.key)) {
    auto values = table.numbers(key.key, key.may_be_negative ? kNumber : kLength, kListed);
    if (!values) return std::nullopt;
    std::ranges::sort(*values);
    const auto twice = std::ranges::adjacent_find(*values);
    if (twice != values->end()) {
      table.fault(key.key, fmt::format("has {} twice; expected different values", *twice));
    }
    return RasterRule{.step = std::nullopt, .values = *std::move(values)};
  }
  if (table.has_word(key.key, kRasterFree)) return RasterRule{};
  if (table.has_text(key.key) && table.text(key.key) == kRasterFree) return RasterRule{};
  const auto step = table.number(key.key, kLength);
  return step ? std::optional(RasterRule{.step = *step, .values = {}}) : std::nullopt;
}

}  // namespace

std::optional<Raster> read_raster(TableReader& document, std::span<const std::string_view> keys,
                                  std::string_view refusal) {
  if (!document.contains(kTable)) return std::nullopt;
  TableReader table = document.table(kTable);
  const std::size_t faults_before = document.faults().size();
  Raster raster;
  for (const RasterKey& key : kRasterKeys) {
    if (std::ranges::find(keys, key.key) == keys.end()) continue;
    table.know({key.key});
    if (!table.contains(key.key)) continue;
    auto rule = read_rule(table, key);
    if (rule) raster.rules.emplace_back(key.key, *std::move(rule));
  }
  raster.boxes = table.integer(kRasterBoxesKey, 1, 100'000'000).value_or(raster.boxes);
  table.finish();
  if (!refusal.empty()) document.fault(kTable, refusal);
  const bool is_any =
      std::ranges::any_of(raster.rules, [](const auto& entry) { return !entry.second.is_free(); });
  if (!is_any && document.faults().size() == faults_before) {
    document.fault(kTable, fmt::format("puts no dimension on a raster; expected at least one of {}",
                                       fmt::join(keys, ", ")));
  }
  return raster;
}

void check_raster_values(TableReader& document, const Raster& raster, std::string_view key,
                         std::string_view group, const Range& range, std::string_view bounds_key) {
  const RasterRule* rule = raster.rule(key, group);
  if (rule == nullptr) return;
  const double reach = kReach * rule->step.value_or(1);
  if (values_within(*rule, range, {-reach, reach}).count() > 0) return;
  document.fault(kTable, fmt::format("has no value of {} within {} = [{}, {}]; expected at least "
                                     "one: widen the bounds or refine the raster",
                                     key, bounds_key, range.min, range.max));
}

Table raster_table(const std::optional<Raster>& raster) {
  if (!raster) return {};
  TableWriter table;
  for (const auto& [key, rule] : raster->rules) {
    if (rule.step) {
      table.set(key, *rule.step);
    } else if (rule.values.empty()) {
      table.set(key, kRasterFree);
    } else {
      table.set(key, rule.values);
    }
  }
  table.set(kRasterBoxesKey, raster->boxes);
  return TableWriter().set(kTable, table).take();
}

}  // namespace cognate::problems::reading
