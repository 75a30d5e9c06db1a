#include "problems/cam/read_raster.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "problems/basics/names.hpp"
#include "problems/cam/raster.hpp"
#include "problems/raster/keys.hpp"
#include "problems/raster/read.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::string_view kRaster = "raster";

std::string_view cam_raster_refusal(const CamProblem& problem) {
  if (problem.objective != CamObjective::size) {
    return "is given with another target.objective than \"size\"; of a cam the smallest on the "
           "raster is found: remove one of them";
  }
  if (!problem.free_motion.empty()) {
    return "is given with angles or shares of the motion that are free; give them numbers";
  }
  if (problem.second.closure == cam::Closure::constant_breadth && problem.second.breadth) {
    return "is given with follower.breadth, from which the base radius follows; remove one of them";
  }
  return {};
}

/// The keys of the follower's lengths.
std::vector<std::string_view> keys_of(const CamProblem& problem) {
  std::vector<std::string_view> keys{"length"};
  for (const auto& [name, dimension] : names<CamDimension>()) {
    if (problem.length(dimension).used) keys.push_back(name);
  }
  return keys;
}

/// A face goes through its pivot unless a key says that it may be set off; that of the raster does.
void free_face_offset(TableReader& document, CamProblem& problem) {
  constexpr auto kFace = CamDimension::face_offset;
  const std::string_view key = to_string(kFace);
  const bool is_given =
      document.table("mechanism").contains(key) || document.table("follower").contains(key);
  if (problem.raster->has(key) && !is_given) problem.length(kFace).given.reset();
}

/// Faults the key of a length that `[mechanism]` or `[follower]` gives.
void check_not_given(TableReader& document, const CamProblem& problem) {
  TableReader table = document.table(kRaster);
  for (const auto& [name, dimension] : names<CamDimension>()) {
    const auto& given = problem.length(dimension).given;
    if (!given || !problem.raster->has(name)) continue;
    table.fault(name, fmt::format("is of a length that is given as {}; expected one of them, or "
                                  "neither",
                                  *given));
  }
}

/// Whether the file's bounds or its list end the values of `dimension`, where anything must.
bool has_end(const CamProblem& problem, CamDimension dimension) {
  const RasterRule* rule = problem.raster->rule(to_string(dimension));
  const Range& bounds = problem.length(dimension).bounds;
  return dimension == CamDimension::base_radius || !rule->step ||
         (std::isfinite(bounds.min) && std::isfinite(bounds.max));
}

/// Faults a free length that the raster says nothing of, or too much; false where it does.
bool check_rule(TableReader& document, const CamProblem& problem, CamDimension dimension) {
  const std::string_view key = to_string(dimension);
  if (problem.raster->rule(key) == nullptr) {
    document.fault(kRaster, fmt::format("leaves {} free, and a cam is found on the raster alone; "
                                        "expected raster.{} or mechanism.{}",
                                        key, key, key));
    return false;
  }
  if (has_end(problem, dimension)) return true;
  document.fault(kRaster, fmt::format("has values of {} without end; expected bounds.{} = [min, "
                                      "max], or a list of values",
                                      key, key));
  return false;
}

/// Faults an axis without a value; false where it has none.
bool check_values(TableReader& document, const CamProblem& problem, const CamRasterAxis& axis) {
  if (axis.values.count() > 0) return true;
  const auto& [min, max] = problem.length(axis.dimension).bounds;
  const std::string_view key = to_string(axis.dimension);
  document.fault(kRaster, fmt::format("has no value of {} within bounds.{} = [{}, {}]; expected at "
                                      "least one: widen the bounds or refine the raster",
                                      key, key, min, max));
  return false;
}

}  // namespace

void read_cam_raster(TableReader& document, CamProblem& problem) {
  if (document.contains(kRaster)) {
    TableReader table = document.table(kRaster);
    if (table.contains(kRasterBoxesKey)) {
      table.fault(kRasterBoxesKey,
                  "is of branch and bound, and combinations of a cam's lengths are tried one by "
                  "one; remove it");
    }
  }
  problem.raster = read_raster(document, keys_of(problem), cam_raster_refusal(problem));
  if (!problem.raster) return;
  free_face_offset(document, problem);
  check_not_given(document, problem);
}

void check_cam_raster(TableReader& document, const CamProblem& problem) {
  bool is_sound = true, has_any = false;
  for (const auto& [name, dimension] : names<CamDimension>()) {
    if (!problem.length(dimension).used || problem.length(dimension).given) continue;
    has_any = true;
    is_sound &= check_rule(document, problem, dimension);
  }
  if (!has_any) {
    document.fault(kRaster, "puts no dimension on a raster that [mechanism] leaves open");
    return;
  }
  if (!is_sound) return;
  const auto axes = cam_raster_axes(problem);
  for (const CamRasterAxis& axis : axes) is_sound &= check_values(document, problem, axis);
  const double others = combinations_beside_base(axes);
  if (!is_sound || others <= kMostCamCombinations) return;
  document.fault(kRaster,
                 fmt::format("has {:.6g} combinations of lengths other than the base radius, each "
                             "of which is tried; expected at most {}: narrow the bounds or take "
                             "larger steps",
                             others, kMostCamCombinations));
}

Table cam_raster_table(const CamProblem& problem) {
  Table document = raster_table(problem.raster);
  for (Entry& entry : document) {
    auto& table = std::get<Table>(entry.node.value);
    std::erase_if(table, [](const Entry& row) { return row.key == kRasterBoxesKey; });
  }
  return document;
}

}  // namespace cognate::problems::reading
