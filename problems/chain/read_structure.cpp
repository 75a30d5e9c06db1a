#include "problems/chain/read_structure.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "problems/chain/check_names.hpp"
#include "problems/chain/places.hpp"
#include "problems/chain/read_parts.hpp"
#include "problems/mechanism/part_names.hpp"
#include "problems/toml/nearest.hpp"

namespace cognate::problems::reading {
namespace {

using synthesis::ChainLine;
using synthesis::LineType;

constexpr std::size_t kMostDyads = 10, kMostPoints = 24;
static_assert(kMostPoints < synthesis::kMostLines);  // a motion adds its heading

/// A dyad, a three-pin link or a point on its way into the chain.
struct Part {
  TableReader* table;
  LineType type;
  std::string name;                  ///< of a three-pin link that of its third pin
  std::vector<Mention> closes_on;    ///< of a slider one point, of a three-pin link three
  std::optional<Mention> through{};  ///< of a slider: the pivot from which its guide counts
  std::vector<std::string> pins{};   ///< of a three-pin link
};

class StructureReader {
 public:
  StructureReader(PartTables& parts, TableReader& mechanism)
      : parts_(parts), mechanism_(mechanism), before_(mechanism.faults().size()) {
    topology_.name = kChainWord;
  }

  std::optional<Topology> read() {
    check_counts();
    for (TableReader& table : parts_.pivots) add_pivot(table);
    for (TableReader& table : parts_.cranks) add_crank(table);
    for (TableReader& table : parts_.points) announce_part(table, LineType::attached, "on");
    std::vector<Part> points = std::exchange(waiting_, {});
    for (TableReader& table : parts_.dyads) announce_part(table, LineType::dyad, "joins");
    std::vector<Part> dyads = std::exchange(waiting_, {});
    if (failed()) return std::nullopt;
    place_all(std::move(points), dyads);
    return failed() ? std::nullopt : std::optional(std::move(topology_));
  }

 private:
  bool failed() const { return mechanism_.faults().size() > before_; }

  void check_counts() {
    if (parts_.pivots.empty()) mechanism_.fault("pivot", "is missing; a chain has one or more");
    if (parts_.cranks.empty()) mechanism_.fault("crank", "is missing; a chain is driven by one");
    if (parts_.dyads.empty()) mechanism_.fault("dyad", "is missing; a chain has one or more");
    if (parts_.dyads.size() > kMostDyads) {
      mechanism_.fault("dyad", fmt::format("has {} entries; at most {} are designed",
                                           parts_.dyads.size(), kMostDyads));
    }
    std::size_t points = 0;
    for (const auto& [type, tables] : parts_.all()) points += tables->size();
    // The guide of a slider counts as a point, a three-pin link as six.
    points += static_cast<std::size_t>(std::ranges::count_if(parts_.dyads, is_slider));
    points += 5 * static_cast<std::size_t>(std::ranges::count_if(parts_.dyads, is_three_pin_link));
    if (points <= kMostPoints) return;
    mechanism_.faults().add(
        mechanism_.where(),
        fmt::format("the chain has {} points; at most {} are designed", points, kMostPoints));
  }

  int find(const std::string& name) const {
    const auto found = std::ranges::find_if(topology_.lines, [&](const TopologyLine& line) {
      return line.name == name && is_point(line.line.type);
    });
    return found == topology_.lines.end() ? -1 : static_cast<int>(found - topology_.lines.begin());
  }

  void add(const std::string& name, const ChainLine& line) {
    topology_.lines.push_back({.name = name, .line = line});
  }

  bool is_taken(const std::string& name) const {
    return std::ranges::count(names_, name) + std::ranges::count(made_, name) > 0;
  }

  /// A name that no other point has; empty with a fault.
  std::string new_name(TableReader& table, std::string_view key, std::string_view what) {
    const auto name = require_name(table, key, what);
    if (!name) return "";
    if (is_taken(*name)) {
      table.fault(key, fmt::format("is {}, the name of another point; expected a name of its own",
                                   in_quotes(*name)));
      return "";
    }
    names_.push_back(*name);
    return *name;
  }

  void add_pivot(TableReader& table) { add(new_name(table, "name", "the pivot"), {}); }

  void add_crank(TableReader& table) {
    refuse_name(table, "name");
    const auto pivot = require_name(table, "at", "the pivot it turns about");
    const std::string pin = new_name(table, "pin", "its pin");
    const int at = pivot ? find(*pivot) : -1;
    if (pivot && at < 0) {
      table.fault("at", fmt::format("is {}, which is no pivot; expected the name of a [[pivot]]",
                                    in_quotes(*pivot)));
    }
    add(pin, {LineType::crank, at});
  }

  static void refuse_name(TableReader& table, std::string_view key) {
    if (!table.has(key)) return;
    table.fault(key,
                "is given, but links of a chain that is designed are named by their points; "
                "remove it");
  }

  void announce_part(TableReader& table, LineType type, std::string_view joins) {
    const bool closes = type == LineType::dyad;
    if (closes && is_three_pin_link(table)) return announce_three_pins(table, joins);
    if (closes) {
      if (!check_type(table)) return;
      refuse_name(table, "names");
    }
    const auto name = closes ? new_name(table, "new", "the dyad's inner joint")
                             : new_name(table, "name", "the point");
    if (!table.has(joins)) {
      table.fault(joins, closes ? "is missing; expected the names of the two points that it joins"
                                : "is missing; expected the names of two points of its link");
      return;
    }
    if (closes && is_slider(table)) return announce_slider(table, name, joins);
    const auto mentions = read_mentions(table, joins, {2, 2, "names of points"});
    if (mentions) waiting_.push_back({&table, type, name, *mentions});
  }

  static bool is_slider(TableReader& table) {
    constexpr std::string_view kType = "type";
    return table.has_text(kType) && *table.text(kType) == to_string(DyadType::rrp);
  }

  void announce_slider(TableReader& table, const std::string& name, std::string_view joins) {
    const auto mentions = read_mentions(table, joins, {1, 1, "names of points"});
    if (!mentions) return;
    take_name(table, name, guide_name(name));
    Part part{&table, LineType::slider, name, *mentions};
    if (table.has_table("slide")) {
      TableReader slide = table.table("slide");
      part.through = read_mention(slide, "through");
    }
    waiting_.push_back(std::move(part));
  }

  /// A name of the program's own, made of that of a point.
  void take_name(TableReader& table, const std::string& point, const std::string& made) {
    if (is_taken(made)) {
      table.fault("new", fmt::format("has {}, but the name {} that goes with it is that of another "
                                     "point; rename one",
                                     in_quotes(point), in_quotes(made)));
    }
    made_.push_back(made);
  }

  void announce_three_pins(TableReader& table, std::string_view joins) {
    refuse_name(table, "names");
    for (const std::string_view key : {"length", "lengths", "assembly", "slide"}) {
      if (!table.contains(key)) continue;
      table.know({key});
      table.fault(key, kThreePinsAreFound);
    }
    for (const std::string_view key : {joins, std::string_view("new")}) {
      if (!table.has(key)) table.fault(key, "is missing; expected the names of three points");
    }
    const auto mentions = read_mentions(table, joins, {3, 3, "names of points"});
    const auto pins = read_mentions(table, "new", {3, 3, "names of points"});
    if (!mentions || !pins) return;
    Part part{&table, LineType::third_pin, pins->back().name, *mentions};
    for (const Mention& pin : *pins) {
      if (!check_name(table, pin.where, pin.called, pin.name)) return;
      if (is_taken(pin.name)) {
        fault(pin, fmt::format("has {}, the name of another point; expected names of their own",
                               in_quotes(pin.name)));
      }
      names_.push_back(pin.name);
      part.pins.push_back(pin.name);
    }
    for (const std::string& pin : {part.pins[0], part.pins[1]}) {
      take_name(table, pin, drawn_name(pin));
    }
    take_name(table, part.name, third_link_name(part.closes_on[2].name, part.name));
    waiting_.push_back(std::move(part));
  }

  /// False, with a fault, for a word that is no type: what else the table has is not known then.
  bool check_type(TableReader& table) const {
    constexpr std::string_view kType = "type";
    const auto type = table.has_text(kType) ? from_string<DyadType>(*table.text(kType))
                                            : std::optional<DyadType>{};
    if (table.has(kType) && !type) {
      const std::array<std::string_view, 3> words{to_string(DyadType::rrr),
                                                  to_string(DyadType::rrp), kThreePinWord};
      table.choice_of(kType, words);
      table.know({"joins", "new", "names", "lengths", "length", "assembly", "slide", "slides",
                  "offset", "slot_deg"});
      return false;
    }
    if (is_slider(table)) {
      table.know({"length", "slide"});
    } else if (type && type != DyadType::rrr) {
      table.fault(
          kType,
          fmt::format("is \"{}\"; a chain is designed of RRR and RRP dyads and three-pin links",
                      to_string(*type)));
      table.know({"slide", "slides", "offset", "slot_deg", "length"});
    }
    return true;
  }

  /// Points follow the dyad that their link comes with, as early as they can.
  void place_all(std::vector<Part> points, const std::vector<Part>& dyads) {
    const auto place_points = [&] {
      while (std::erase_if(points, [&](const Part& part) {
               return is_placeable(part) && (place(part), true);
             }) > 0) {
      }
    };
    place_points();
    for (const Part& dyad : dyads) {
      place(dyad);
      if (failed()) return;
      place_points();
    }
    for (const Part& point : points) place(point);
  }

  bool is_placeable(const Part& part) const {
    const int first = find(part.closes_on[0].name), second = find(part.closes_on[1].name);
    return first >= 0 && second >= 0 && first != second && common_body(first, second);
  }

  std::optional<int> common_body(int first, int second) const {
    return ChainPlaces(chain_of(topology_).lines).common_body(first, second);
  }

  void fault(const Mention& mention, const std::string& text) {
    mechanism_.faults().add(mention.where, mention.called + " " + text);
  }

  void place_slider(const Part& part) {
    const Mention& from = part.closes_on[0];
    const int first = find(from.name);
    if (first < 0) return fault(from, unknown_point(from));
    if (topology_.lines[static_cast<std::size_t>(first)].line.type == LineType::pivot) {
      return fault(from,
                   fmt::format("has {}, a point of the frame; expected a point of a link that "
                               "drives the slider",
                               in_quotes(from.name)));
    }
    add(guide_name(part.name), {LineType::guide, pivot_of(part)});
    add(part.name, {LineType::slider, first, static_cast<int>(topology_.lines.size()) - 1});
  }

  /// The pivot from which the offset of a slider's guide counts: that of the crank where the file
  /// names none.
  int pivot_of(const Part& part) {
    const auto is_of = [](LineType type) {
      return [type](const TopologyLine& line) { return line.line.type == type; };
    };
    if (!part.through) {
      return std::ranges::find_if(topology_.lines, is_of(LineType::crank))->line.first;
    }
    const int pivot = find(part.through->name);
    const bool is_pivot =
        pivot >= 0 && is_of(LineType::pivot)(topology_.lines[static_cast<std::size_t>(pivot)]);
    if (!is_pivot) {
      fault(*part.through,
            fmt::format("is {}, which is no pivot; expected the name of a [[pivot]], "
                        "from which the guide's offset counts",
                        in_quotes(part.through->name)));
    }
    return std::max(pivot, 0);
  }

  void place_three_pins(const Part& part) {
    std::vector<int> from;
    for (const Mention& mention : part.closes_on) {
      from.push_back(find(mention.name));
      if (from.back() < 0) return fault(mention, unknown_point(mention));
      if (std::ranges::count(from, from.back()) > 1) {
        return fault(mention,
                     fmt::format("has {} twice; expected three points", in_quotes(mention.name)));
      }
    }
    const auto body = common_body(from[0], from[1]);
    if (body && body == common_body(from[1], from[2])) {
      return fault(part.closes_on[2],
                   "are three points of one body, between which the link cannot move; expected "
                   "points of two bodies or three");
    }
    const auto line = [&] { return static_cast<int>(topology_.lines.size()); };
    const auto& pins = part.pins;
    add(third_link_name(part.closes_on[2].name, pins[2]), {LineType::third_link, from[2]});
    for (std::size_t i = 0; i < 2; ++i) add(drawn_name(pins[i]), {LineType::drawn});
    add(pins[0], {LineType::first_pin, from[0]});
    add(pins[1], {LineType::second_pin, from[1], line() - 1});
    add(pins[2], {LineType::third_pin, line() - 2, line() - 1});
  }

  void place(const Part& part) {
    if (part.type == LineType::slider) return place_slider(part);
    if (part.type == LineType::third_pin) return place_three_pins(part);
    const auto& [from, to] = std::pair(part.closes_on[0], part.closes_on[1]);
    for (const Mention& mention : {from, to}) {
      if (find(mention.name) < 0) return fault(mention, unknown_point(mention));
    }
    const int first = find(from.name), second = find(to.name);
    if (first == second) {
      return fault(to, fmt::format("has {} twice; expected two points", in_quotes(to.name)));
    }
    const auto body = common_body(first, second);
    if (part.type == LineType::dyad && body) {
      return fault(to, fmt::format("are two points of one body, between which a dyad cannot move; "
                                   "expected points of two bodies, or [[point]] on = [\"{}\", "
                                   "\"{}\"]",
                                   from.name, to.name));
    }
    if (part.type == LineType::attached && !body) {
      return fault(to, fmt::format("has {} and {}, which no link has both; expected two points of "
                                   "one link",
                                   in_quotes(from.name), in_quotes(to.name)));
    }
    if (part.type == LineType::attached && *body == 0) {
      return fault(to,
                   "are two points of the frame; expected a [[pivot]] instead, or two points "
                   "of a link");
    }
    add(part.name, {part.type, first, second});
  }

  std::string unknown_point(const Mention& mention) const {
    const bool comes_later = std::ranges::find(names_, mention.name) != names_.end();
    return fmt::format("has {}, which {}; expected one of {}", in_quotes(mention.name),
                       comes_later ? "only a later part places" : "is no point of the chain",
                       quoted_points(topology_));
  }

  PartTables& parts_;
  TableReader& mechanism_;
  std::size_t before_;
  Topology topology_;
  std::vector<std::string> names_, made_;  ///< of points; of the program's own
  std::vector<Part> waiting_;
};

}  // namespace

std::optional<Topology> read_structure(PartTables& parts, TableReader& mechanism,
                                       TableReader& target, const Wanted& wanted) {
  auto topology = StructureReader(parts, mechanism).read();
  const bool is_wanted = topology && choose_wanted(*topology, {parts, mechanism, target}, wanted);
  if (!is_wanted) {
    target.know({wanted.key});
    return std::nullopt;
  }
  check_names(*topology, mechanism);
  return topology;
}

}  // namespace cognate::problems::reading
