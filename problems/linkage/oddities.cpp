#include "problems/linkage/oddities.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/basics/unit_notes.hpp"
#include "problems/linkage/verify.hpp"

namespace cognate::problems {
namespace {

constexpr double kLeastAcute = 5 * kDegree;
constexpr double kTooLong = 100, kNearChangePoint = 1e-3;

constexpr std::size_t kMostNumbers = 10;  ///< of designs in one note

/// The target of a design, where it came.
TargetExtent placed_at(const TargetExtent& target, const Design& design) {
  if (!design.placement) return target;
  return {design.placement->point(target.centre), design.placement->scale * target.size};
}

double longest_link(const Lengths<double>& links) {
  return std::max({links.crank, links.coupler, links.rocker, links.frame});
}

double shortest_link(const Lengths<double>& links) {
  return std::min({links.crank, links.coupler, links.rocker, links.frame});
}

bool is_near_change_point(const Design& design) {
  return !design.metrics.change_point &&
         std::abs(grashof_excess(lengths(four_bar(design)))) <= kNearChangePoint;
}

/// How far the farther fixed pivot is from a place.
double farther_pivot(const FourBar& linkage, const Vec2d& place) {
  return std::max(norm(linkage.pivot_a - place), norm(linkage.pivot_d - place));
}

bool has_forces(const Operation& operation) {
  return !operation.loads.empty() || norm(operation.gravity) > 0 ||
         std::ranges::any_of(operation.links, [](const LinkMass& link) {
           return link.mass > 0 || link.moment > 0 || link.mass_per_length > 0;
         });
}

/// The four-bars of which something is the case.
template <class Predicate>
void note_designs(const Predicate& is_odd, const std::string& what, Result& result) {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < result.designs.size(); ++i) {
    const Design& design = result.designs[i];
    const bool judged = design.mechanism.four_bar() && all_satisfied(design.constraints);
    if (judged && is_odd(design)) numbers.push_back(i + 1);
  }
  if (numbers.empty()) return;
  const std::string more = numbers.size() > kMostNumbers ? ", …" : "";
  if (numbers.size() > kMostNumbers) numbers.resize(kMostNumbers);
  result.notes.push_back(fmt::format("Design {}{}: {}", fmt::join(numbers, ", "), more, what));
}

}  // namespace

std::optional<TargetExtent> extent_of(std::span<const Vec2d> points) {
  TargetExtent extent;
  const double share = 1.0 / static_cast<double>(points.size());
  for (const Vec2d& point : points) extent.centre = extent.centre + share * point;
  double squares = 0;
  for (const Vec2d& point : points) squares += squared_norm(point - extent.centre);
  extent.size = std::sqrt(share * squares);
  return extent.size > 0 ? std::optional(extent) : std::nullopt;
}

void note_oddities(const std::optional<TargetExtent>& target, Result& result, double noted) {
  note_designs(
      [&](const Design& design) {
        const double acute = design.metrics.transmission_acute_min;
        return acute < kLeastAcute && acute > noted;
      },
      "the transmission angle comes within 5 degrees of 0 or 180, near a dead point: joints bear "
      "more than ten times the force transmitted there, and the output hardly follows; "
      "constraints.transmission_angle_deg keeps away.",
      result);
  const auto is_long = [&](const Design& design) {
    return target &&
           longest_link(lengths(four_bar(design))) > kTooLong * placed_at(*target, design).size;
  };
  note_designs(
      is_long,
      "a link is more than 100 times as long as the target is large; bounds.length keeps links "
      "shorter.",
      result);
  note_designs(
      [&](const Design& design) {
        if (!target || is_long(design)) return false;
        const TargetExtent there = placed_at(*target, design);
        return farther_pivot(four_bar(design), there.centre) > kTooLong * there.size;
      },
      "a fixed pivot lies more than 100 times the target's size away from it; "
      "constraints.pivot_region keeps it nearer.",
      result);
  note_designs(
      [&](const Design& design) {
        const Lengths<double> links = lengths(four_bar(design));
        return !is_long(design) && longest_link(links) > kTooLong * shortest_link(links);
      },
      "the longest link is more than 100 times as long as the shortest; "
      "constraints.link_ratio_max keeps them alike.",
      result);
  note_designs(
      is_near_change_point,
      "the lengths are within a thousandth of a change point, where all links lie on one line: "
      "clearances and tolerances decide there which way the linkage goes on.",
      result);
}

void note_units(const Operation& operation, std::optional<LengthUnit> unit, Result& result) {
  if (!has_forces(operation)) return;
  const FourBar* best =
      result.designs.empty() ? nullptr : result.designs.front().mechanism.four_bar();
  const double longest = best ? longest_link(lengths(*best)) : 0;
  for (auto& note : unit_notes({unit, operation.gravity, longest})) {
    result.notes.push_back(std::move(note));
  }
}

}  // namespace cognate::problems
