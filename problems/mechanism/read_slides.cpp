#include "problems/mechanism/read_slides.hpp"

#include <fmt/core.h>

#include "problems/mechanism/directions.hpp"
#include "problems/mechanism/quantity_rules.hpp"
#include "problems/toml/nearest.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::string_view kThrough = "through";

std::optional<int> read_body(TableReader& table, const Chain& chain, SlideDescription& slide) {
  const auto on = read_mention(table, "on");
  if (!on) return table.has("on") ? std::nullopt : std::optional(0);
  slide.on = on->name;
  return find_body(chain.names, *on, table.faults());
}

// The named point in the axes of `body`.
std::optional<Vec2d> read_named_point(TableReader& table, Chain& chain, int body,
                                      SlideDescription& slide) {
  const auto mention = *read_mention(table, kThrough);
  slide.through = mention.name;
  chain.used.push_back(mention.name);
  const auto index = find_point(chain.names, mention, table.faults());
  if (!index) return std::nullopt;
  const NamedParts& parts = chain.names.parts();
  const PointOnLink& point = parts.points[*index];
  const auto place = place_on(point, body);
  if (!place) {
    table.fault(
        kThrough,
        fmt::format("is {}, which is no point of {} but of {}; expected on = one of these, or a "
                    "point of the slide's body",
                    in_quotes(point.name), in_quotes(parts.bodies[body].name),
                    body_list(parts, point.on)));
  }
  return place;
}

std::optional<Vec2d> read_through(TableReader& table, Chain& chain, int body,
                                  SlideDescription& slide) {
  if (!table.has(kThrough)) {
    table.fault(kThrough, "is missing; expected a point [x, y] or the name of one");
    return std::nullopt;
  }
  if (table.has_text(kThrough)) return read_named_point(table, chain, body, slide);
  const auto place = table.two(kThrough, kQuantity, "[x, y] or the name of a point");
  if (!place) return std::nullopt;
  const Vec2d through{(*place)[0], (*place)[1]};
  slide.through = through;
  return through;
}

}  // namespace

std::optional<ReadSlide> read_slide(TableReader& table, Chain& chain) {
  ReadSlide slide;
  const std::size_t before = table.faults().size();
  const auto body = read_body(table, chain, slide.description);
  const auto through = read_through(table, chain, body.value_or(0), slide.description);
  const double degrees = read_degrees(table, "direction_deg", 0);
  slide.description.direction = radians(degrees);
  slide.description.offset = table.number("offset", kQuantity).value_or(0);
  table.finish();
  if (!body || !through || table.faults().size() != before) return std::nullopt;
  slide.guide = {*body, *through, unit_vector_at_degrees(degrees), slide.description.offset};
  return slide;
}

std::optional<ReadSlide> read_slide_of(TableReader& table, Chain& chain) {
  constexpr std::string_view kSlide = "slide";
  if (!table.has(kSlide)) {
    table.fault(kSlide, "is missing; expected slide = {through = ..., direction_deg = ...}");
    return std::nullopt;
  }
  TableReader slide = table.table(kSlide);
  return read_slide(slide, chain);
}

}  // namespace cognate::problems::reading
