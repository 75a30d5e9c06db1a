#include "problems/cam/read_conditions.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "problems/cam/rules.hpp"

namespace cognate::problems::reading {
namespace {

using cam::MotionCondition;

constexpr std::size_t kMostConditions = cam::MotionPiece<double>::kMostTerms;
constexpr std::size_t kMostPoints = 100'000;
constexpr std::string_view kConditions = "conditions", kPoints = "points";

// The keys of a condition, each at the order of its derivative.
using Orders = std::array<std::string_view, 4>;

constexpr Orders orders(bool oscillating) {
  return {oscillating ? "displacement_deg" : "displacement", "velocity", "acceleration", "jerk"};
}

// Which derivative `table` gives; nothing, with a fault, where it gives none or several.
std::optional<int> order_of(TableReader& table, const Orders& keys) {
  std::optional<int> order;
  int count = 0;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (!table.has(keys[i])) continue;
    order = static_cast<int>(i);
    ++count;
  }
  if (count == 1) return order;
  table.fault(keys[0],
              fmt::format("{}, or velocity, acceleration or jerk instead; expected one of them",
                          count == 0 ? "is missing" : "is given beside another"));
  return std::nullopt;
}

std::optional<MotionCondition> read_condition(TableReader& table, bool oscillating,
                                              const cam::MotionSegment& segment, double over_deg) {
  if (!table.has("at_deg")) {
    table.fault("at_deg",
                fmt::format("is missing; expected an angle in degrees from 0 to {} from the "
                            "segment's beginning",
                            over_deg));
  }
  const auto at = table.number("at_deg", kPlaceInSegment);
  const Orders keys = orders(oscillating);
  const auto order = order_of(table, keys);
  const auto value =
      order ? table.number(keys.at(static_cast<std::size_t>(*order)), kQuantity) : std::nullopt;
  table.finish();
  if (!at || !value) return std::nullopt;
  if (*at > over_deg) {
    table.fault("at_deg",
                fmt::format("is {}, beyond the segment; expected an angle from 0 to {} degrees",
                            *at, over_deg));
    return std::nullopt;
  }
  const bool angle = oscillating && *order == 0;
  return MotionCondition{radians(*at) / segment.over, *order, angle ? radians(*value) : *value};
}

bool same_place(const MotionCondition& a, const MotionCondition& b) {
  return a.at == b.at && a.order == b.order;
}

// The displacements of both ends count among them whether they are given or not.
std::size_t count_with_ends(const cam::MotionSegment& segment) {
  std::size_t count = segment.conditions.size();
  for (const double end : {0.0, 1.0}) {
    const auto is_end = [&](const auto& c) { return same_place(c, {end, 0, 0}); };
    if (std::ranges::none_of(segment.conditions, is_end)) ++count;
  }
  return count;
}

bool check_conditions(TableReader& table, const cam::MotionSegment& segment) {
  for (const MotionCondition& condition : segment.conditions) {
    if (condition.order != 0 || (condition.at != 0 && condition.at != 1)) continue;
    const double is = condition.at == 0 ? 0 : segment.rise;
    if (condition.value == is) continue;
    table.fault(kConditions, fmt::format("contradict the segment at its {}; the displacement is 0 "
                                         "at its beginning and the rise at its end",
                                         condition.at == 0 ? "beginning" : "end"));
    return false;
  }
  const std::size_t count = count_with_ends(segment);
  if (count > kMostConditions) {
    table.fault(kConditions,
                fmt::format("are {} with the displacements of both ends; expected at most {}",
                            count, kMostConditions));
    return false;
  }
  std::vector<cam::MotionPiece<double>> pieces;
  if (cam::append_pieces(segment, 0, 0, 0, pieces)) return true;
  table.fault(
      kConditions,
      fmt::format("have no polynomial of degree {} that meets them all, or many; "
                  "expected conditions that differ in angle or derivative and do not leave a "
                  "lower derivative open everywhere",
                  count - 1));
  return false;
}

std::optional<Two> read_ends(TableReader& table, std::string_view key) {
  const auto ends = table.two(key, kQuantity, "[begin, end]");
  if (table.has(key) && !ends) return std::nullopt;
  return ends.value_or(Two{});
}

void refuse(TableReader& table, std::initializer_list<std::string_view> keys,
            std::string_view why) {
  for (const std::string_view key : keys) {
    if (table.has(key)) table.fault(key, fmt::format("is given, but {}; remove it", why));
  }
}

bool read_points(TableReader& table, bool oscillating, double over_deg,
                 cam::MotionSegment& segment) {
  const std::string_view form =
      oscillating ? "[at_deg, displacement_deg]" : "[at_deg, displacement]";
  if (!table.has(kPoints)) {
    table.fault(kPoints, fmt::format("is missing; expected an array of {}", form));
    return false;
  }
  const auto points = table.twos(kPoints, kQuantity, form, {1, kMostPoints, "points"});
  if (!points) return false;
  double last = 0;
  for (std::size_t i = 0; i < points->size(); ++i) {
    const auto& [at, displacement] = (*points)[i];
    const double share = radians(at) / segment.over;
    if (!(share > last) || !(share < 1)) {
      table.faults().add(
          table.where(kPoints, i),
          fmt::format("entry {} of {} stands at {} degrees; expected angles that increase, "
                      "above 0 and below {}",
                      i + 1, table.name(kPoints), at, over_deg));
      return false;
    }
    segment.points.push_back({share, oscillating ? radians(displacement) : displacement});
    last = share;
  }
  return true;
}

bool read_degree(TableReader& table, cam::MotionSegment& segment) {
  constexpr std::string_view kDegree = "degree";
  const auto degree = table.integer(kDegree, 3, 5);
  if (table.has(kDegree) && !degree) return false;
  segment.degree = degree.value_or(segment.degree);
  if (segment.degree != 4) return true;
  table.fault(kDegree, "is 4; expected 3 or 5");
  return false;
}

bool check_periodic(TableReader& table, double over_deg, const cam::MotionSegment& segment) {
  if (!segment.ends.periodic) return true;
  refuse(table, {"velocity", "acceleration"}, "the ends of a periodic spline follow");
  if (over_deg == 360 && segment.rise == 0) return true;
  table.fault("periodic",
              "is true, but the segment is no whole turn without rise; expected over_deg = 360 "
              "and a rise of 0");
  return false;
}

bool check_spline(TableReader& table, const cam::MotionSegment& segment) {
  std::vector<cam::MotionPiece<double>> pieces;
  if (cam::append_pieces(segment, 0, 0, 0, pieces)) return true;
  table.fault(kPoints,
              fmt::format("have no spline of degree {} that can be computed; expected points "
                          "farther apart",
                          segment.degree));
  return false;
}

}  // namespace

bool read_conditions(TableReader& table, bool oscillating, double over_deg,
                     cam::MotionSegment& segment) {
  if (!table.has(kConditions)) {
    table.fault(
        kConditions,
        "is missing; expected an array of {at_deg, displacement | velocity | acceleration | jerk}");
    return false;
  }
  const std::size_t before = table.faults().size();
  for (TableReader& row : table.tables(kConditions, {1, kMostConditions, "conditions"})) {
    const auto condition = read_condition(row, oscillating, segment, over_deg);
    if (!condition) continue;
    const auto same = [&](const auto& other) { return same_place(other, *condition); };
    if (std::ranges::any_of(segment.conditions, same)) {
      row.fault("at_deg",
                "is that of another condition on the same derivative; expected each at an angle "
                "once");
    }
    segment.conditions.push_back(*condition);
  }
  return table.faults().size() == before && check_conditions(table, segment);
}

bool read_spline(TableReader& table, bool oscillating, double over_deg,
                 cam::MotionSegment& segment) {
  const bool points = read_points(table, oscillating, over_deg, segment);
  const bool degree = read_degree(table, segment);
  const auto velocity = read_ends(table, "velocity");
  const auto acceleration = read_ends(table, "acceleration");
  segment.ends.periodic = table.boolean("periodic").value_or(false);
  if (!points || !degree || !velocity || !acceleration) return false;
  segment.ends.velocity_begin = (*velocity)[0];
  segment.ends.velocity_end = (*velocity)[1];
  segment.ends.acceleration_begin = (*acceleration)[0];
  segment.ends.acceleration_end = (*acceleration)[1];
  if (segment.degree == 3) {
    refuse(table, {"acceleration"}, "that at the ends of a cubic spline follows");
  }
  return check_periodic(table, over_deg, segment) && check_spline(table, segment);
}

}  // namespace cognate::problems::reading
