#include "problems/mechanism/read_group.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "analysis/mechanism/followed_motion.hpp"
#include "analysis/mechanism/group_equations.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/mechanism/directions.hpp"
#include "problems/mechanism/quantity_rules.hpp"
#include "problems/toml/nearest.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::string_view kBodies = "names";
constexpr std::string_view kAt = "at";
constexpr std::string_view kDirections = "direction_deg";
constexpr std::string_view kJoint = "joint";
constexpr std::string_view kOf = "of";

constexpr std::size_t kMostJoints = std::size_t{3} * kMostGroupBodies / 2;

/// In parts of a group: joints farther apart than this are not where the file says.
constexpr double kApart = 1e-6;

/// Reads one group.
class GroupReader {
 public:
  GroupReader(TableReader& table, Chain& chain)
      : table_(table),
        chain_(chain),
        first_(static_cast<int>(chain.names.parts().bodies.size())),
        before_(table.faults().size()) {}

  void read() {
    read_bodies();
    read_joints();
    table_.finish();
    if (is_sound() && !chain_.names.incomplete) add_to_chain();
    if (!is_sound()) chain_.names.incomplete = true;
  }

 private:
  bool is_sound() const { return table_.faults().size() == before_; }

  void read_bodies() {
    table_.know({kAt, kDirections});
    if (!table_.has(kBodies)) table_.fault(kBodies, "is missing; expected the names of the bodies");
    const auto names = read_mentions(table_, kBodies, {4, kMostGroupBodies, "names"});
    const bool slides = driven_by_length(chain_.mechanism.drive);
    const std::string_view drive = slides ? "drive" : "drive_deg";
    if (!table_.has(drive)) {
      table_.fault(drive,
                   "is missing; expected the drive's position in which the group stands as "
                   "\"at\" and \"direction_deg\" say");
    }
    const double value = table_.number(drive, kQuantity).value_or(0);
    description_.drive = slides ? value : radians(value);
    if (!names) return;
    names_ = *names;
    if (names_.size() % 2 != 0) {
      table_.fault(kBodies, fmt::format("has {} names; expected an even number", names_.size()));
    }
    for (const Mention& name : names_) {
      check_name(table_, name.where, name.called, name.name);
      const auto same = std::ranges::find(description_.names, name.name);
      if (same != description_.names.end()) {
        table_.faults().add(name.where, fmt::format("{} is {}, the name of another of the bodies",
                                                    name.called, in_quotes(name.name)));
      }
      description_.names.push_back(name.name);
    }
    read_places({names_.size(), names_.size(), "of the bodies"});
  }

  void read_places(const Count& count) {
    for (const std::string_view key : {kAt, kDirections}) {
      if (!table_.has(key)) table_.fault(key, "is missing; expected one for each of \"names\"");
    }
    const auto at = table_.twos(kAt, kQuantity, "[x, y]", count);
    const auto directions = table_.numbers(kDirections, kQuantity, count);
    if (!at || !directions) return;
    for (std::size_t i = 0; i < at->size(); ++i) {
      description_.drawn.push_back(
          {{(*at)[i][0], (*at)[i][1]}, unit_vector_at_degrees((*directions)[i])});
    }
  }

  void read_joints() {
    if (!is_sound()) return table_.know({kJoint});  // what follows from the bodies is no fault
    const std::size_t wanted = 3 * names_.size() / 2;
    if (!table_.has(kJoint)) return table_.fault(kJoint, "is missing; expected [[dyad.joint]]");
    auto tables = table_.tables(kJoint, {0, kMostJoints, "joints"});
    if (!tables.empty() && tables.size() != wanted) {
      table_.fault(kJoint, fmt::format("has {} joints of {} bodies; expected {}, three for two",
                                       tables.size(), names_.size(), wanted));
    }
    for (TableReader& joint : tables) read_joint(joint);
  }

  /// The number of a body of the group or of one before it.
  std::optional<int> body_of(const Mention& mention) {
    const auto own = std::ranges::find(names_, mention.name, &Mention::name);
    if (own != names_.end()) return first_ + static_cast<int>(own - names_.begin());
    return find_body(chain_.names, mention, table_.faults());
  }

  void read_joint(TableReader& table) {
    GroupJointDescription joint;
    joint.name = read_name(table, "name").value_or("");
    for (const std::string_view key : {kOf, kAt}) {
      if (!table.has(key)) table.fault(key, "is missing; expected one for each of two bodies");
    }
    const auto of = read_mentions(table, kOf, {2, 2, "bodies"});
    const auto at = table.twos(kAt, kQuantity, "[x, y]", {2, 2, "places"});
    if (table.has(kDirections)) {
      const auto directions = table.numbers(kDirections, kQuantity, {2, 2, "angles"});
      if (directions) joint.directions = {radians((*directions)[0]), radians((*directions)[1])};
    } else if (joint.name.empty()) {
      table.fault("name", "is missing; a pin has a name, a slide direction_deg");
    }
    table.finish();
    if (!of || !at) return;
    std::array<std::optional<int>, 2> bodies;
    for (std::size_t i = 0; i < 2; ++i) {
      joint.of[i] = (*of)[i].name;
      joint.at[i] = {(*at)[i][0], (*at)[i][1]};
      bodies[i] = body_of((*of)[i]);
    }
    if (!bodies[0] || !bodies[1]) return;
    if (*bodies[0] == *bodies[1] || (*bodies[0] < first_ && *bodies[1] < first_)) {
      return table.fault(kOf, "joins no body of the group to another");
    }
    add_joint(table, std::move(joint), {*bodies[0], *bodies[1]});
  }

  /// With the body that is there before as the first.
  void add_joint(TableReader& table, GroupJointDescription joint, std::array<int, 2> bodies) {
    if (bodies[1] < first_) {
      std::swap(bodies[0], bodies[1]);
      std::swap(joint.of[0], joint.of[1]);
      std::swap(joint.at[0], joint.at[1]);
      if (joint.directions) std::swap((*joint.directions)[0], (*joint.directions)[1]);
    }
    check_place(table, joint, bodies);
    GroupJoint added{{bodies[0], joint.at[0]}, {bodies[1], joint.at[1]}};
    if (const auto& directions = joint.directions) {
      added.slides = true;
      added.along_first = unit_vector_at_degrees(degrees((*directions)[0]));
      added.along_second = unit_vector_at_degrees(degrees((*directions)[1]));
    }
    group_.joints.push_back(added);
    description_.joints.push_back(std::move(joint));
  }

  /// A pin named as a point that is there is that point, and pins of one name are one.
  void check_place(TableReader& table, const GroupJointDescription& joint,
                   const std::array<int, 2>& bodies) {
    if (joint.directions) return;
    const auto is_at = [&](const Attached<double>& place) {
      for (std::size_t i = 0; i < 2; ++i) {
        const double size = std::max(norm1(joint.at[i]), norm1(place.at));
        if (place.body == bodies[i]) return norm1(place.at - joint.at[i]) <= kApart * size;
      }
      return false;
    };
    const auto known = chain_.names.point(joint.name);
    bool is_new = !known, is_there = false;
    if (known) is_there = std::ranges::any_of(chain_.names.parts().points[*known].on, is_at);
    for (std::size_t i = 0; i < description_.joints.size(); ++i) {
      if (description_.joints[i].name != joint.name) continue;
      is_new = false;
      const GroupJoint& other = group_.joints[i];
      is_there = is_there || is_at(other.first) || is_at(other.second);
    }
    if (is_new || is_there) return;
    table.fault("name",
                fmt::format("is {}, the name of a point at another place", in_quotes(joint.name)));
  }

  void add_to_chain() {
    group_.drawn = description_.drawn;
    group_.drive = description_.drive;
    Mechanism<double> mechanism = chain_.mechanism;
    mechanism.dyads.push_back(group_);
    mechanism.dyads.resize(mechanism.dyads.size() + names_.size() / 2 - 1, GroupRest{});
    check_closes(mechanism);
    if (!is_sound()) return;
    for (const Mention& name : names_) {
      add_body(chain_.names, name, false, "", table_.faults());
      chain_.steady.push_back(std::nullopt);
    }
    for (std::size_t i = 0; i < group_.joints.size(); ++i) {
      const GroupJointDescription& joint = description_.joints[i];
      if (joint.directions) continue;
      chain_.used.push_back(joint.name);
      chain_.names.place(joint.name, group_.joints[i].first);
      chain_.names.place(joint.name, group_.joints[i].second);
    }
    chain_.mechanism = std::move(mechanism);
    chain_.description.dyads.push_back(
        {.type = DyadType::group, .names = {}, .group = std::move(description_)});
  }

  void check_closes(const Mechanism<double>& mechanism) {
    const auto slot = static_cast<int>(chain_.mechanism.dyads.size());
    FollowedMotion<1> before(chain_.mechanism,
                             follow(chain_.mechanism, group_.drive, group_.drive));
    if (!before.move_to(group_.drive)) {
      return table_.fault(kAt,
                          "is for a position of the drive in which the bodies before the "
                          "group cannot be assembled");
    }
    std::vector<BodyMotion<double, 1>> bodies(static_cast<std::size_t>(body_count(mechanism)));
    std::ranges::copy(before.bodies(), bodies.begin());
    const auto first = static_cast<std::size_t>(first_body(mechanism, slot));
    place_drawn(group_, std::span(bodies).subspan(first));
    const GroupEquations equations(group_, first);
    const double apart = equations.residual<1>(bodies).lpNorm<Eigen::Infinity>();
    const double size = equations.arm();
    if (!(apart <= kApart * size)) {
      return table_.fault(kAt, fmt::format("and \"direction_deg\" leave the joints of the group up "
                                           "to {:.3g} apart; expected places in which they meet",
                                           apart));
    }
    if (!(std::abs(group_sine(equations.matrix<1>(bodies))) > kDeadGroupSine)) {
      table_.fault(kAt,
                   "is a dead point of the group, where two assemblies meet, or a part of it "
                   "cannot move while another is loose; expected another position");
    }
  }

  TableReader& table_;
  Chain& chain_;
  int first_;
  std::size_t before_;
  std::vector<Mention> names_;
  GroupDescription description_;
  Group group_;
};

}  // namespace

void announce_joints(TableReader& table, PartNames& names) {
  if (!table.has_array(kJoint)) return;
  std::vector<std::string> own;
  if (table.has_array(kBodies)) own = table.texts(kBodies, {}).value_or(own);
  const auto is_own = [&](const std::string& body) {
    return std::ranges::find(own, body) != own.end();
  };
  std::vector<std::string> pins;
  for (TableReader& joint : table.tables(kJoint, {})) {
    const auto name = joint.has_text("name") ? joint.text("name") : std::nullopt;
    if (!name) continue;
    const bool is_known = names.is_announced(*name) && std::ranges::find(pins, *name) == pins.end();
    const auto of = joint.has_array(kOf) ? joint.texts(kOf, {}) : std::nullopt;
    if (is_known && of && std::ranges::all_of(*of, is_own)) {
      joint.fault("name", fmt::format("is {}, the name of another point", in_quotes(*name)));
    }
    pins.push_back(*name);
    if (!is_known) names.announce(*name);
  }
}

void read_group(TableReader& table, Chain& chain) {
  GroupReader(table, chain).read();
}

}  // namespace cognate::problems::reading
