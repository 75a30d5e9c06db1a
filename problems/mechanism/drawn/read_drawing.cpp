#include "problems/mechanism/drawn/read_drawing.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "problems/mechanism/directions.hpp"
#include "problems/mechanism/part_names.hpp"
#include "problems/mechanism/quantity_rules.hpp"
#include "problems/toml/nearest.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::string_view kJoint = "joint";
constexpr std::string_view kDriven = "driven";
constexpr std::string_view kAt = "at";
constexpr std::string_view kOf = "of";
constexpr std::string_view kDirection = "direction_deg";
constexpr std::string_view kFrame = "frame";
/// As many as 200 dyads have, each with a further point.
constexpr std::size_t kMostJoints = 1000;
constexpr std::size_t kMostLinksOfJoint = 20;

/// The numbers of links by their names, and what is wrong with the joints.
class DrawingReader {
 public:
  explicit DrawingReader(FaultList& faults) : faults_(faults) {}

  void read(TableReader& table) {
    DrawnJoint joint;
    joint.name = require_name(table, "name", "the joint").value_or("");
    joint.where = table.where("name");
    read_links(table, joint);
    if (table.has(kDirection)) {
      joint.direction = unit_vector_at_degrees(read_degrees(table, kDirection, 0));
    }
    read_place(table, joint);
    check_links(table, joint);
    table.finish();
    const bool is_new = joint.name.empty() || names_.insert(joint.name).second;
    if (!is_new) {
      table.fault("name", fmt::format("is {}, the name of another joint", in_quotes(joint.name)));
    }
    drawing_.joints.push_back(std::move(joint));
  }

  void read_driven(TableReader& mechanism) {
    if (!mechanism.has(kDriven)) {
      return mechanism.fault(kDriven,
                             "is missing; expected the name of the link that drives, which has "
                             "one joint with the frame");
    }
    const auto name = mechanism.text(kDriven);
    if (!name) return;
    const auto link = numbers_.find(*name);
    if (link == numbers_.end() || link->second == 0) {
      return mechanism.fault(kDriven, fmt::format("is {}; expected a link that joints join: {}",
                                                  in_quotes(*name), moving_links()));
    }
    drawing_.driven = link->second;
    const bool on_frame = std::ranges::any_of(drawing_.joints, [&](const DrawnJoint& joint) {
      return joins(joint, 0) && joins(joint, drawing_.driven);
    });
    if (!on_frame) {
      mechanism.fault(kDriven, fmt::format("is {}, which has no joint with the frame; expected a "
                                           "link that has one",
                                           in_quotes(*name)));
    }
  }

  Drawing take() { return std::move(drawing_); }

  /// Joints and links share no name.
  void check_names() {
    for (const DrawnJoint& joint : drawing_.joints) {
      if (!numbers_.contains(joint.name)) continue;
      faults_.add(joint.where, fmt::format("joint.name is {}, the name of a link; expected another",
                                           in_quotes(joint.name)));
    }
  }

 private:
  void read_links(TableReader& table, DrawnJoint& joint) {
    if (!table.has(kOf)) {
      return table.fault(kOf,
                         "is missing; expected the links that it joins, of = [\"...\", "
                         "\"...\"]; \"frame\" is the fixed one");
    }
    const auto mentions = read_mentions(table, kOf, {1, kMostLinksOfJoint, "links"});
    if (!mentions) return;
    for (const Mention& link : *mentions) {
      if (!check_name(table, link.where, link.called, link.name)) continue;
      const auto [entry, is_new] = numbers_.try_emplace(link.name, drawing_.links.size());
      if (is_new) drawing_.links.push_back(link.name);
      if (joins(joint, entry->second)) {
        table.fault(kOf, fmt::format("has {} twice", in_quotes(link.name)));
      } else {
        joint.of.push_back(entry->second);
      }
    }
  }

  static void read_place(TableReader& table, DrawnJoint& joint) {
    if (joint.direction) {
      if (table.has(kAt)) {
        table.fault(kAt,
                    "is given for a slide, whose line runs through the pin of its slider; "
                    "expected none beside direction_deg");
      }
      return;
    }
    if (!table.has(kAt)) {
      table.fault(kAt, "is missing; expected [x, y], or the direction_deg of a slide");
    }
    const Two at = table.two(kAt, kQuantity, "[x, y]").value_or(Two{});
    joint.at = {at[0], at[1]};
  }

  static void check_links(TableReader& table, const DrawnJoint& joint) {
    if (joint.of.empty()) return;
    if (joint.direction && joint.of.size() != 2) {
      table.fault(kOf, fmt::format("has {} links; a slide has two", joint.of.size()));
    }
    if (joint.of.size() == 1 && joint.of.front() == 0) {
      table.fault(kOf, "is the frame alone, where nothing turns; expected another link, too");
    }
  }

  std::string moving_links() const {
    std::vector<std::string_view> links(drawing_.links.begin() + 1, drawing_.links.end());
    return links.empty() ? "there is none" : listed(std::move(links));
  }

  FaultList& faults_;
  Drawing drawing_;
  std::map<std::string, std::size_t, std::less<>> numbers_{{std::string(kFrame), 0}};
  std::set<std::string, std::less<>> names_;
};

}  // namespace

bool is_drawn(const TableReader& document, const TableReader& mechanism) {
  return document.contains(kJoint) || mechanism.contains(kJoint) || mechanism.contains(kDriven);
}

Drawing read_drawing(TableReader& document, TableReader& mechanism) {
  FaultList& faults = document.faults();
  const std::size_t before = faults.size();
  for (const std::string_view key : {"pivot", "crank", "slider", "cylinder", "dyad"}) {
    TableReader& place = holder(key, document, mechanism);
    if (place.has(key)) {
      place.fault(key,
                  "is given beside [[joint]]; a chain has its joints as drawn, or its drive "
                  "and dyads");
    }
  }
  DrawingReader reader(faults);
  TableReader& place = holder(kJoint, document, mechanism);
  if (!place.has(kJoint)) {
    place.fault(kJoint, "is missing; expected the joints of the mechanism, one of which is driven");
  }
  for (TableReader& joint : place.tables(kJoint, {1, kMostJoints, "joints"})) reader.read(joint);
  if (faults.size() == before || mechanism.has(kDriven)) reader.read_driven(mechanism);
  if (faults.size() == before) reader.check_names();
  return reader.take();
}

}  // namespace cognate::problems::reading
