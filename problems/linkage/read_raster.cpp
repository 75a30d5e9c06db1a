#include "problems/linkage/read_raster.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <variant>

#include "problems/linkage/linkage_keys.hpp"
#include "problems/raster/read.hpp"

namespace cognate::problems::reading {

std::string_view search_raster_refusal(const Solve& solve) {
  if (!solve.objectives.empty()) {
    return "is given with solve.objectives; a raster is searched for the least error alone: remove "
           "one of them";
  }
  if (solve.loss != synthesis::Loss::none) {
    return "is given with solve.loss; a raster is searched by least squares alone: remove one of "
           "them";
  }
  if (solve.certify) {
    return "is given with solve.certify, which says nothing of rasters; remove one of them";
  }
  return {};
}

std::string_view robust_search_refusal(const Solve& solve) {
  if (!solve.objectives.empty()) {
    return "is given with solve.objectives, which it takes the place of; remove one of them";
  }
  if (solve.loss != synthesis::Loss::none) {
    return "is given with solve.loss; robust designs start from least squares: remove one of them";
  }
  if (solve.certify) {
    return "is given with solve.certify, which says nothing of quantiles; remove one of them";
  }
  return {};
}

std::string_view robust_tolerance_refusal(const std::optional<Tolerances>& tolerances) {
  if (!tolerances) {
    return "is given without tolerances, of which it is a quantile; add [tolerance] or remove it";
  }
  const auto is_off = [](const ToleranceValue& value) {
    const auto* deviation = std::get_if<Deviation>(&value);
    return deviation == nullptr || deviation->plus > 0 || deviation->minus > 0;
  };
  const bool has_any = (tolerances->length && is_off(*tolerances->length)) ||
                       std::ranges::any_of(tolerances->dimensions, is_off, &NamedTolerance::value);
  if (has_any) return {};
  return "is given, but no length has a tolerance; add tolerance.length or one of a link, or "
         "remove it";
}

void check_raster_bounds(TableReader& document, const Raster& raster, const Given& given,
                         const Bounds& bounds) {
  for (const LinkKey& link : kLinkKeys) {
    const std::optional<Range>& range = bounds.*link.bounds;
    const bool follows = link.key == "frame" && raster.rule("pivots") != nullptr;
    if (given.*link.given || !range || follows) continue;
    check_raster_values(document, raster, link.key, {}, *range, "bounds." + std::string(link.key));
  }
  for (const BoundedPlaceKey& place : kPlaceKeys) {
    const std::optional<Box>& box = bounds.*place.bounds;
    if (given.*place.given || !box) continue;
    const std::string_view key = place.key == "coupler_point" ? "coupler_point" : "pivots";
    const std::string name = "bounds." + std::string(place.key);
    check_raster_values(document, raster, key, {}, {box->min.x, box->max.x}, name);
    check_raster_values(document, raster, key, {}, {box->min.y, box->max.y}, name);
  }
}

}  // namespace cognate::problems::reading
