#include "problems/mechanism/read_chain_dyads.hpp"

#include <fmt/core.h>

#include <array>
#include <utility>

#include "problems/mechanism/directions.hpp"
#include "problems/mechanism/quantity_rules.hpp"
#include "problems/mechanism/read_dyad_keys.hpp"
#include "problems/mechanism/read_group.hpp"
#include "problems/mechanism/read_slides.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::string_view kNames = "names";

// A point that lies on one of the dyad's own bodies (0 or 1), at a place in its axes.
struct OwnPlace {
  std::string point;
  int body = 0;
  Vec2d at{};
};

// A dyad on its way into the chain. `dyad` is empty while something is wrong or unknown.
struct ReadDyad {
  DyadDescription description;
  std::optional<Dyad<double>> dyad;
  std::vector<OwnPlace> places;
  /// Of bodies that slide: the point they may share a name with. Empty for those that do not.
  std::array<std::string, 2> pins;
  std::array<std::string, 2> default_names;
  std::array<std::optional<Vec2d>, 2> steady;
};

std::string pair_name(const std::string& first, const std::string& second) {
  const bool letters = first.size() == 1 && second.size() == 1;
  return letters ? first + second : fmt::format("{}-{}", first, second);
}

Attached<double> place(const Chain& chain, std::size_t point) {
  return chain.names.parts().points[point].on.front();
}

void read_rrr(TableReader& table, Chain& chain, ReadDyad& read) {
  DyadDescription& dyad = read.description;
  const auto joins = read_joins(table, chain, 2, "joins = [\"...\", \"...\"]", dyad);
  const auto lengths = read_lengths(table, 2);
  read_assembly(table, dyad);
  read_new(table, dyad);
  if (joins.empty() || !may_move(table, chain, joins) || !lengths) return;
  dyad.lengths = *lengths;
  const double first = dyad.lengths[0];
  const double second = dyad.lengths[1];
  read.dyad =
      Rrr<double>{place(chain, joins[0]), place(chain, joins[1]), first, second, dyad.assembly};
  read.places = {{dyad.joins[0], 0, {}},
                 {dyad.joins[1], 1, {}},
                 {dyad.new_point, 0, {first, 0}},
                 {dyad.new_point, 1, {second, 0}}};
  read.default_names = {pair_name(dyad.joins[0], dyad.new_point),
                        pair_name(dyad.new_point, dyad.joins[1])};
}

void read_rrp(TableReader& table, Chain& chain, ReadDyad& read) {
  DyadDescription& dyad = read.description;
  const auto joins = read_joins(table, chain, 1, "joins = \"...\"", dyad);
  const auto lengths = read_lengths(table, 1);
  const auto slide = read_slide_of(table, chain);
  read_assembly(table, dyad);
  read_new(table, dyad);
  if (joins.empty() || !lengths || !slide) return;
  if (!may_move(table, chain, joins[0], slide->guide.body)) return;
  dyad.lengths = *lengths;
  dyad.slides = {slide->description};
  read.dyad = Rrp<double>{place(chain, joins[0]), dyad.lengths[0], slide->guide, dyad.assembly};
  read.places = {
      {dyad.joins[0], 0, {}}, {dyad.new_point, 0, {dyad.lengths[0], 0}}, {dyad.new_point, 1, {}}};
  read.pins = {"", dyad.new_point};
  read.default_names = {pair_name(dyad.joins[0], dyad.new_point), dyad.new_point};
  read.steady = {std::nullopt, steady_direction(chain, slide->guide)};
}

void read_rpr(TableReader& table, Chain& chain, ReadDyad& read) {
  DyadDescription& dyad = read.description;
  const auto joins =
      read_joins(table, chain, 2, "joins = [the block's point, the bar's pivot]", dyad);
  dyad.offset = table.number("offset", kQuantity).value_or(0);
  read_assembly(table, dyad);
  if (joins.empty() || !may_move(table, chain, joins)) return;
  read.dyad =
      Rpr<double>{place(chain, joins[0]), place(chain, joins[1]), dyad.offset, dyad.assembly};
  read.places = {{dyad.joins[0], 0, {}}, {dyad.joins[1], 1, {}}};
  read.pins = {dyad.joins[0], ""};
  read.default_names = {dyad.joins[0], pair_name(dyad.joins[1], dyad.joins[0])};
}

void read_prp(TableReader& table, Chain& chain, ReadDyad& read) {
  DyadDescription& dyad = read.description;
  const auto slides = read_two_slides(table, chain);
  read_new(table, dyad);
  if (slides.size() != 2) return;
  const Guide<double>& first = slides[0].guide;
  const Guide<double>& second = slides[1].guide;
  if (!may_move(table, chain, first, second)) return;
  dyad.slides = {slides[0].description, slides[1].description};
  read.dyad = Prp<double>{first, second};
  read.places = {{dyad.new_point, 0, {}}, {dyad.new_point, 1, {}}};
  read.pins = {dyad.new_point, dyad.new_point};
  read.default_names = {dyad.new_point + "1", dyad.new_point + "2"};
  read.steady = {steady_direction(chain, first), steady_direction(chain, second)};
}

void read_rpp(TableReader& table, Chain& chain, ReadDyad& read) {
  DyadDescription& dyad = read.description;
  const auto joins = read_joins(table, chain, 1, "joins = \"...\"", dyad);
  const auto slide = read_slide_of(table, chain);
  const double degrees = read_degrees(table, "slot_deg", 90);
  const Vec2d slot = unit_vector_at_degrees(degrees);
  read_new(table, dyad);
  if (are_parallel(slot, {1, 0})) {
    table.fault("slot_deg",
                fmt::format("is {}, parallel to the slide; expected an angle from the slide "
                            "that is no multiple of 180",
                            degrees));
    return;
  }
  if (joins.empty() || !slide || !may_move(table, chain, joins[0], slide->guide.body)) return;
  dyad.slot = radians(degrees);
  dyad.slides = {slide->description};
  read.dyad = Rpp<double>{place(chain, joins[0]), slot, slide->guide};
  read.places = {{dyad.joins[0], 0, {}}, {dyad.new_point, 1, {}}};
  read.pins = {dyad.joins[0], dyad.new_point};
  read.default_names = {dyad.joins[0], dyad.new_point};
  const auto steady = steady_direction(chain, slide->guide);
  if (steady) read.steady = {*steady * slot, steady};
}

void read_type(TableReader& table, Chain& chain, ReadDyad& read) {
  switch (read.description.type) {
    case DyadType::rrr:
      return read_rrr(table, chain, read);
    case DyadType::rrp:
      return read_rrp(table, chain, read);
    case DyadType::rpr:
      return read_rpr(table, chain, read);
    case DyadType::prp:
      return read_prp(table, chain, read);
    case DyadType::rpp:
      return read_rpp(table, chain, read);
    case DyadType::group:
      return;
  }
}

// The names of the two bodies, given or by default, and where they are given.
std::optional<std::vector<Mention>> read_body_names(TableReader& table, const ReadDyad& read) {
  if (!table.has(kNames)) {
    std::vector<Mention> names;
    for (const std::string& name : read.default_names) {
      names.push_back({name, table.where(), table.name(kNames)});
    }
    return names;
  }
  auto names = read_mentions(table, kNames, {2, 2, "names"});
  if (!names) return std::nullopt;
  for (const Mention& name : *names) {
    if (!check_name(table, name.where, name.called, name.name)) return std::nullopt;
  }
  return names;
}

void add_bodies(TableReader& table, Chain& chain, ReadDyad& read,
                const std::vector<Mention>& names) {
  const int first = static_cast<int>(chain.names.parts().bodies.size());
  for (std::size_t i = 0; i < 2; ++i) {
    add_body(chain.names, names[i], !read.pins[i].empty(), read.pins[i], table.faults());
    read.description.names[i] = names[i].name;
    chain.steady.push_back(read.steady[i]);
  }
  for (const OwnPlace& own : read.places) {
    chain.names.place(own.point, {first + own.body, own.at});
  }
}

}  // namespace

void read_dyad(TableReader& table, Chain& chain) {
  constexpr std::string_view kType = "type";
  if (!table.has(kType)) {
    table.fault(kType,
                "is missing; expected \"RRR\", \"RRP\", \"RPR\", \"PRP\", \"RPP\" or \"group\"");
  }
  const std::size_t before = table.faults().size();
  const auto type = table.choice<DyadType>(kType);
  if (!type) {  // which keys it has cannot be known
    chain.names.incomplete = true;
    return;
  }
  if (*type == DyadType::group) return read_group(table, chain);
  ReadDyad read;
  read.description.type = *type;
  read_type(table, chain, read);
  const auto names = read_body_names(table, read);
  table.finish();
  if (!read.dyad || !names || table.faults().size() != before) {
    chain.names.incomplete = true;
    return;
  }
  add_bodies(table, chain, read, *names);
  chain.mechanism.dyads.push_back(*read.dyad);
  chain.description.dyads.push_back(std::move(read.description));
}

}  // namespace cognate::problems::reading
