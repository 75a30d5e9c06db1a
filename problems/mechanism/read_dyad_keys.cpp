#include "problems/mechanism/read_dyad_keys.hpp"

#include <fmt/core.h>

#include "problems/mechanism/directions.hpp"
#include "problems/mechanism/quantity_rules.hpp"
#include "problems/toml/nearest.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::string_view kJoins = "joins";
constexpr std::string_view kNew = "new";
constexpr std::string_view kSlides = "slides";

}  // namespace

std::vector<std::size_t> read_joins(TableReader& table, Chain& chain, std::size_t count,
                                    std::string_view form, DyadDescription& dyad) {
  if (!table.has(kJoins)) {
    table.fault(kJoins, fmt::format("is missing; expected {}", form));
    return {};
  }
  const auto mentions = read_mentions(table, kJoins, {count, count, "points"});
  if (!mentions) return {};
  std::vector<std::size_t> points;
  for (const Mention& mention : *mentions) {
    dyad.joins.push_back(mention.name);
    chain.used.push_back(mention.name);
    if (const auto point = find_point(chain.names, mention, table.faults())) {
      points.push_back(*point);
    }
  }
  return points.size() == count ? points : std::vector<std::size_t>{};
}

bool may_move(TableReader& table, const Chain& chain, const std::vector<std::size_t>& joins) {
  const NamedParts& parts = chain.names.parts();
  const PointOnLink& first = parts.points[joins[0]];
  const PointOnLink& second = parts.points[joins[1]];
  if (joins[0] == joins[1]) {
    table.fault(kJoins,
                fmt::format("has {} twice; expected two different points", in_quotes(first.name)));
    return false;
  }
  const auto body = common_body(first, second);
  if (body) {
    table.fault(kJoins, fmt::format("has {} and {}, both points of {}, so that the group cannot "
                                    "move on it (mobility 0); expected points of two bodies",
                                    in_quotes(first.name), in_quotes(second.name),
                                    in_quotes(parts.bodies[*body].name)));
  }
  return !body;
}

bool may_move(TableReader& table, const Chain& chain, std::size_t joined, int guide_body) {
  const NamedParts& parts = chain.names.parts();
  const PointOnLink& point = parts.points[joined];
  if (!place_on(point, guide_body)) return true;
  table.fault(kJoins,
              fmt::format("has {}, a point of {}, which also carries the slide, so that the group "
                          "cannot move on it (mobility 0); expected a point of another body",
                          in_quotes(point.name), in_quotes(parts.bodies[guide_body].name)));
  return false;
}

std::optional<std::vector<double>> read_lengths(TableReader& table, std::size_t count) {
  constexpr std::string_view kLengths = "lengths";
  constexpr std::string_view kLength = "length";
  if (count == 1 && table.has(kLength)) {
    const auto length = table.number(kLength, kLinkLength);
    return length ? std::optional(std::vector{*length}) : std::nullopt;
  }
  if (!table.has(kLengths)) {
    table.fault(count == 1 ? kLength : kLengths,
                count == 1
                    ? "is missing; expected the length from the joined point to the slider's pin"
                    : "is missing; expected [l1, l2], from the joined points to the new one");
    return std::nullopt;
  }
  return table.numbers(kLengths, kLinkLength, {count, count, "lengths"});
}

std::vector<ReadSlide> read_two_slides(TableReader& table, Chain& chain) {
  if (!table.has(kSlides)) {
    table.fault(kSlides,
                "is missing; expected slides = [{through = ..., direction_deg = ...}, {...}]");
    return {};
  }
  std::vector<ReadSlide> slides;
  for (TableReader& entry : table.tables(kSlides, {2, 2, "slides"})) {
    if (const auto slide = read_slide(entry, chain)) slides.push_back(*slide);
  }
  return slides;
}

void read_assembly(TableReader& table, DyadDescription& dyad) {
  dyad.assembly = table.choice<Assembly>("assembly").value_or(Assembly::open);
}

void read_new(TableReader& table, DyadDescription& dyad) {
  dyad.new_point = require_name(table, kNew, "the dyad's inner joint").value_or("");
}

std::optional<Vec2d> steady_direction(const Chain& chain, const Guide<double>& guide) {
  const auto& body = chain.steady[guide.body];
  return body ? std::optional(*body * guide.direction) : std::nullopt;
}

bool may_move(TableReader& table, const Chain& chain, const Guide<double>& first,
              const Guide<double>& second) {
  if (first.body == second.body) {
    table.fault(kSlides, fmt::format("are both on {}, so that the group cannot move on it "
                                     "(mobility 0); expected slides on two bodies",
                                     in_quotes(chain.names.parts().bodies[first.body].name)));
    return false;
  }
  const auto a = steady_direction(chain, first);
  const auto b = steady_direction(chain, second);
  const bool cross = !a || !b || !are_parallel(*a, *b);
  if (!cross) {
    table.fault(kSlides,
                "stay parallel and never cross in one point; expected slides in different "
                "directions");
  }
  return cross;
}

}  // namespace cognate::problems::reading
