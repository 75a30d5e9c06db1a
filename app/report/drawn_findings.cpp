#include "app/report/drawn_findings.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/report/drawn_number.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;

/// Points of all loci together, and rows of a family, that a page holds at most.
constexpr std::size_t kPoints = 6000, kRows = 400;

/// About `most` of `count` indices in equal steps, first and last among them.
std::vector<std::size_t> coarsened(std::size_t count, std::size_t most) {
  std::vector<std::size_t> kept;
  if (count == 0) return kept;
  const std::size_t step = std::max<std::size_t>(1, (count + most - 1) / most);
  for (std::size_t i = 0; i + 1 < count; i += step) kept.push_back(i);
  kept.push_back(count - 1);
  return kept;
}

std::size_t point_count(std::span<const problems::Locus> loci) {
  std::size_t count = 0;
  for (const auto& locus : loci) {
    for (const auto& branch : locus.branches) count += branch.size();
  }
  return count;
}

/// Null where a point is not finite: there the curve has a gap.
ordered_json point_or_gap(const Vec2d& point) {
  const ordered_json x = drawn(point.x), y = drawn(point.y);
  if (x.is_null() || y.is_null()) return nullptr;
  return ordered_json::array({x, y});
}

}  // namespace

ordered_json drawn_loci(std::span<const problems::Locus> loci) {
  const double share =
      std::min(1.0, static_cast<double>(kPoints) / static_cast<double>(point_count(loci) + 1));
  ordered_json list = ordered_json::array();
  for (const auto& locus : loci) {
    ordered_json branches = ordered_json::array();
    for (const auto& branch : locus.branches) {
      const auto most = std::max<std::size_t>(
          32, static_cast<std::size_t>(share * static_cast<double>(branch.size())));
      ordered_json points = ordered_json::array();
      for (const std::size_t i : coarsened(branch.size(), most))
        points.push_back(point_or_gap(branch[i]));
      branches.push_back(points);
    }
    list.push_back({{"name", locus.name}, {"branches", branches}});
  }
  return list;
}

ordered_json drawn_families(std::span<const problems::Family> families) {
  ordered_json list = ordered_json::array();
  for (const auto& family : families) {
    ordered_json columns = ordered_json::array();
    for (const auto& column : family.columns) {
      ordered_json values = ordered_json::array();
      for (const std::size_t i : coarsened(column.values.size(), kRows)) {
        values.push_back(drawn(column.values[i]));
      }
      columns.push_back({{"name", column.name}, {"values", values}});
    }
    list.push_back({{"name", family.name}, {"columns", columns}});
  }
  return list;
}

}  // namespace cognate::app
