#include "problems/linkage/same_design.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "analysis/linkage/cognates.hpp"
#include "analysis/linkage/mobility.hpp"

namespace cognate::problems {
namespace {

double size_of(const FourBar& linkage) {
  const Lengths<double> links = lengths(linkage);
  const double point = linkage.coupler_point ? norm(*linkage.coupler_point) : 0;
  return std::max({links.crank, links.coupler, links.rocker, links.frame, point});
}

/// As `same_design`, for any assemblies.
bool same_dimensions(const FourBar& a, const FourBar& b, double tolerance) {
  if (a.coupler_point.has_value() != b.coupler_point.has_value()) return false;
  const double allowed = tolerance * std::max(size_of(a), size_of(b));
  const bool same_point = !a.coupler_point || norm(*a.coupler_point - *b.coupler_point) <= allowed;
  return same_point && norm(a.pivot_a - b.pivot_a) <= allowed &&
         norm(a.pivot_d - b.pivot_d) <= allowed && std::abs(a.crank - b.crank) <= allowed &&
         std::abs(a.coupler - b.coupler) <= allowed && std::abs(a.rocker - b.rocker) <= allowed;
}

/// Some crank angle, from the x axis, at which the linkage closes and is at no dead point.
std::optional<double> some_crank_angle(const FourBar& linkage) {
  const auto ranges = crank_ranges(lengths(linkage));
  if (ranges.empty()) return std::nullopt;
  // Off the middle, where the linkage may be symmetric and crank and rocker parallel.
  return frame_angle(linkage) + ranges[0].from + 0.4 * (ranges[0].to - ranges[0].from);
}

bool matches_from_other_end(const FourBar& a, const FourBar& b, double tolerance) {
  const auto angle = some_crank_angle(a);
  const auto turned = angle ? from_other_end(a, *angle) : std::nullopt;
  return turned && same_dimensions(turned->linkage, b, tolerance);
}

}  // namespace

bool same_design(const FourBar& a, const FourBar& b, double tolerance) {
  return a.assembly == b.assembly && same_dimensions(a, b, tolerance);
}

bool is_cognate(const FourBar& a, const FourBar& b, double tolerance) {
  if (!a.coupler_point || !b.coupler_point) return false;
  if (matches_from_other_end(a, b, tolerance)) return true;
  if (const auto timed = timed_cognate(a)) {
    if (same_design(*timed, b, tolerance)) return true;
    if (matches_from_other_end(*timed, b, tolerance)) return true;
  }
  const auto angle = some_crank_angle(a);
  const auto coupler = angle ? coupler_cognate(a, *angle) : std::nullopt;
  return coupler && (same_dimensions(coupler->linkage, b, tolerance) ||
                     matches_from_other_end(coupler->linkage, b, tolerance));
}

}  // namespace cognate::problems
