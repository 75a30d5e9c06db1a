#include "problems/linkage/four_bar_raster.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "problems/linkage/linkage_keys.hpp"

namespace cognate::problems {
namespace {

/// How far values reach where nothing bounds them, in sizes.
constexpr double kReach = 1000;

/// In the order of kLinkKeys and kPlaceKeys.
constexpr std::array kLinkDimensions{FourBarDimension::crank, FourBarDimension::coupler,
                                     FourBarDimension::rocker, FourBarDimension::frame};
constexpr std::array<std::array<FourBarDimension, 2>, 3> kPlaceDimensions{
    {{FourBarDimension::a_x, FourBarDimension::a_y},
     {FourBarDimension::d_x, FourBarDimension::d_y},
     {FourBarDimension::point_u, FourBarDimension::point_v}}};

class AxisList {
 public:
  AxisList(const FourBarPlaces& places, const Similarity& scale) : places_(places), scale_(scale) {}

  void add_link(const RasterRule& rule, FourBarDimension dimension, std::string_view name,
                const std::optional<Range>& bounds) {
    Range range = bounds.value_or(Range{0, kInfinity});
    // A link of no length is none.
    range.min = std::max(range.min, rule.step ? 0.5 * *rule.step : rule.values.front());
    add(rule, std::string(name), dimension, range, 0);
  }

  void add_place(const RasterRule& rule, const BoundedPlaceKey& key,
                 const std::array<FourBarDimension, 2>& dimensions, const std::optional<Box>& box) {
    const Range open{-kInfinity, kInfinity};
    const bool is_pivot = key.key != "coupler_point";
    const Vec2d offset = is_pivot ? scale_.centre : Vec2d{};
    const std::string name(key.key);
    add(rule, name + "." + std::string(key.first), dimensions[0],
        box ? Range{box->min.x, box->max.x} : open, offset.x);
    add(rule, name + "." + std::string(key.second), dimensions[1],
        box ? Range{box->min.y, box->max.y} : open, offset.y);
  }

  FourBarRaster take() { return std::move(all_); }

 private:
  void add(const RasterRule& rule, std::string name, FourBarDimension dimension, const Range& range,
           double offset) {
    const int place = places_[static_cast<std::size_t>(dimension)];
    if (place < 0) return;
    const double reach = kReach * scale_.size;
    all_.dimensions.push_back(dimension);
    all_.axes.push_back(
        {std::move(name), values_within(rule, range, {offset - reach, offset + reach})});
    all_.variables.push_back({.variable = place, .offset = offset, .scale = scale_.size});
  }

  const FourBarPlaces& places_;
  const Similarity& scale_;
  FourBarRaster all_;
};

}  // namespace

bool has_pivot_raster(const Raster& raster, const Given& given) {
  return (!given.pivot_a || !given.pivot_d) && raster.rule("pivots") != nullptr;
}

FourBarRaster four_bar_raster(const Raster& raster, const Given& given, const Bounds& bounds,
                              const FourBarPlaces& places, const Similarity& scale) {
  AxisList list(places, scale);
  for (std::size_t i = 0; i < kLinkKeys.size(); ++i) {
    const LinkKey& key = kLinkKeys[i];
    const RasterRule* rule = raster.rule(key.key);
    const bool follows = key.key == "frame" && has_pivot_raster(raster, given);
    if (rule != nullptr && !follows) {
      list.add_link(*rule, kLinkDimensions[i], key.key, bounds.*key.bounds);
    }
  }
  for (std::size_t i = 0; i < kPlaceKeys.size(); ++i) {
    const BoundedPlaceKey& key = kPlaceKeys[i];
    const RasterRule* rule = raster.rule(key.key == "coupler_point" ? key.key : "pivots");
    if (rule != nullptr && !(given.*key.given)) {
      list.add_place(*rule, key, kPlaceDimensions[i], bounds.*key.bounds);
    }
  }
  return list.take();
}

void give_dimension(Given& given, FourBarDimension dimension, double value) {
  const auto coordinate = [](std::optional<Vec2d>& point) -> Vec2d& {
    if (!point) point = Vec2d{};
    return *point;
  };
  switch (dimension) {
    case FourBarDimension::crank:
      given.crank = value;
      break;
    case FourBarDimension::coupler:
      given.coupler = value;
      break;
    case FourBarDimension::rocker:
      given.rocker = value;
      break;
    case FourBarDimension::frame:
      given.frame = value;
      break;
    case FourBarDimension::point_u:
      coordinate(given.coupler_point).x = value;
      break;
    case FourBarDimension::point_v:
      coordinate(given.coupler_point).y = value;
      break;
    case FourBarDimension::a_x:
      coordinate(given.pivot_a).x = value;
      break;
    case FourBarDimension::a_y:
      coordinate(given.pivot_a).y = value;
      break;
    case FourBarDimension::d_x:
      coordinate(given.pivot_d).x = value;
      break;
    case FourBarDimension::d_y:
      coordinate(given.pivot_d).y = value;
      break;
  }
}

void set_dimension(FourBar& linkage, FourBarDimension dimension, double value) {
  if (!linkage.coupler_point) linkage.coupler_point = Vec2d{};
  switch (dimension) {
    case FourBarDimension::crank:
      linkage.crank = value;
      break;
    case FourBarDimension::coupler:
      linkage.coupler = value;
      break;
    case FourBarDimension::rocker:
      linkage.rocker = value;
      break;
    case FourBarDimension::frame:
      break;
    case FourBarDimension::point_u:
      linkage.coupler_point->x = value;
      break;
    case FourBarDimension::point_v:
      linkage.coupler_point->y = value;
      break;
    case FourBarDimension::a_x:
      linkage.pivot_a.x = value;
      break;
    case FourBarDimension::a_y:
      linkage.pivot_a.y = value;
      break;
    case FourBarDimension::d_x:
      linkage.pivot_d.x = value;
      break;
    case FourBarDimension::d_y:
      linkage.pivot_d.y = value;
      break;
  }
}

}  // namespace cognate::problems
