#include "problems/linkage/long_links.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "problems/basics/degrees.hpp"

namespace cognate::problems {
namespace {

constexpr double kLong = 30;

/// How far the parts reach that stay short.
double reach_of(const FourBar& linkage, double short_link) {
  const double point = linkage.coupler_point ? norm(*linkage.coupler_point) : 0;
  return std::max({short_link, linkage.coupler, point});
}

/// Of a limit, how far the long links are from infinity: their end departs from a line by so much.
double bend_of(const FourBar& linkage, const SliderLimit& limit) {
  const double reach = reach_of(linkage, limit.crank) + std::abs(limit.offset);
  return reach * reach / (limit.slider_drives ? linkage.crank : linkage.rocker);
}

bool same_limit(const FourBar& a, const FourBar& b) {
  const auto first = slider_limit(a), second = slider_limit(b);
  if (!first || !second || first->slider_drives != second->slider_drives) return false;
  if (a.assembly != b.assembly || a.coupler_point.has_value() != b.coupler_point.has_value()) {
    return false;
  }
  const double allowed = std::max(bend_of(a, *first), bend_of(b, *second));
  const double reach = std::max(reach_of(a, first->crank), reach_of(b, second->crank));
  const bool same_point = !a.coupler_point || norm(*a.coupler_point - *b.coupler_point) <= allowed;
  return same_point && norm(first->pivot - second->pivot) <= allowed &&
         std::abs(first->crank - second->crank) <= allowed &&
         std::abs(first->coupler - second->coupler) <= allowed &&
         std::abs(first->offset - second->offset) <= allowed &&
         reach * norm(first->normal - second->normal) <= allowed;
}

void move_index(std::optional<int>& index, const std::vector<int>& places) {
  if (index) *index = places[static_cast<std::size_t>(*index)];
}

std::string note_of(std::size_t number, const SliderLimit& limit) {
  const double along = degrees(std::atan2(limit.normal.x, -limit.normal.y));
  return fmt::format(
      "Design {}: {} and frame run to infinity together: the linkage tends to a slider-crank{} "
      "with crank {:.6g}, coupler {:.6g}, its slide {:.6g} away from the crank's pivot, in the "
      "direction of {:.6g} degrees.",
      number, limit.slider_drives ? "crank" : "rocker",
      limit.slider_drives ? " that its slider drives," : "", limit.crank, limit.coupler,
      std::abs(limit.offset), along);
}

}  // namespace

std::optional<SliderLimit> slider_limit(const FourBar& linkage) {
  const Vec2d frame = linkage.pivot_d - linkage.pivot_a;
  const double length = norm(frame);
  for (const bool slider_drives : {false, true}) {
    const double long_link = slider_drives ? linkage.crank : linkage.rocker;
    const double short_link = slider_drives ? linkage.rocker : linkage.crank;
    const double least = kLong * reach_of(linkage, short_link);
    if (!(long_link >= least && length >= least)) continue;
    SliderLimit limit{.slider_drives = slider_drives, .crank = short_link};
    limit.pivot = slider_drives ? linkage.pivot_d : linkage.pivot_a;
    limit.normal = (slider_drives ? -1 / length : 1 / length) * frame;
    limit.coupler = linkage.coupler;
    limit.offset = length - long_link;
    return limit;
  }
  return std::nullopt;
}

void merge_long_links(Result& result) {
  std::vector<Design> kept;
  std::vector<int> places;
  for (Design& design : result.designs) {
    const FourBar* linkage = design.mechanism.four_bar();
    const auto known = std::ranges::find_if(kept, [&](const Design& other) {
      return linkage && other.mechanism.four_bar() &&
             same_limit(*other.mechanism.four_bar(), *linkage);
    });
    places.push_back(static_cast<int>(known - kept.begin()));
    if (known != kept.end()) continue;
    move_index(design.cognate_of, places);
    move_index(design.mirror_of, places);
    kept.push_back(std::move(design));
  }
  result.designs = std::move(kept);
  for (std::size_t i = 0; i < result.designs.size(); ++i) {
    const FourBar* linkage = result.designs[i].mechanism.four_bar();
    const auto limit = linkage ? slider_limit(*linkage) : std::nullopt;
    if (limit) result.notes.push_back(note_of(i + 1, *limit));
  }
}

}  // namespace cognate::problems
