/// `[mechanism]`, from its description.
#include "problems/mechanism/write_mechanism.hpp"

#include <array>
#include <string_view>
#include <variant>

#include "analysis/numbers/angle.hpp"
#include "problems/mechanism/mechanism_types.hpp"

namespace cognate::problems::reading {
namespace {

TableWriter slide_writer(const SlideDescription& slide) {
  TableWriter table;
  std::visit([&](const auto& through) { table.set("through", through); }, slide.through);
  return table.set_deg("direction_deg", slide.direction)
      .set("offset", slide.offset)
      .set("on", slide.on);
}

TableWriter drive_writer(const CrankDescription& crank) {
  TableWriter table;
  return table.set("at", crank.at)
      .set("pin", crank.pin)
      .set("length", crank.length)
      .set("name", crank.name);
}

TableWriter drive_writer(const SliderDescription& slider) {
  TableWriter table;
  return table.add("slide", node(slide_writer(slider.slide)))
      .set("pin", slider.pin)
      .set("name", slider.name);
}

TableWriter drive_writer(const CylinderDescription& cylinder) {
  TableWriter table;
  return table.set("at", cylinder.at)
      .set("about", cylinder.about)
      .set("pin", cylinder.pin)
      .set("length", cylinder.length)
      .set_name("assembly", cylinder.assembly)
      .set("names", cylinder.names);
}

TableWriter joint_writer(const GroupJointDescription& joint) {
  TableWriter table;
  if (!joint.directions) table.set("name", joint.name);
  table.set("of", joint.of).set("at", joint.at);
  if (!joint.directions) return table;
  const auto& [first, second] = *joint.directions;
  return table.add("direction_deg", node(Array{node_deg(first), node_deg(second)}));
}

TableWriter group_writer(const GroupDescription& group, bool slides) {
  Array places, directions, joints;
  for (const auto& [origin, direction] : group.drawn) {
    places.push_back(node(origin));
    directions.push_back(node_deg(angle_of(direction)));
  }
  for (const GroupJointDescription& joint : group.joints) {
    joints.push_back(node(joint_writer(joint)));
  }
  TableWriter table;
  table.set_name("type", DyadType::group)
      .set("names", group.names)
      .set("at", places)
      .set("direction_deg", directions);
  slides ? table.set("drive", group.drive) : table.set_deg("drive_deg", group.drive);
  return table.set("joint", joints);
}

TableWriter dyad_writer(const DyadDescription& dyad) {
  TableWriter table;
  table.set_name("type", dyad.type);
  if (!dyad.joins.empty()) table.set("joins", dyad.joins);
  if (!dyad.lengths.empty()) table.set("lengths", dyad.lengths);
  Array slides;
  for (const SlideDescription& slide : dyad.slides) slides.push_back(node(slide_writer(slide)));
  if (dyad.type == DyadType::prp) {
    table.set("slides", slides);
  } else if (!slides.empty()) {
    table.add("slide", slides.front());
  }
  if (dyad.type == DyadType::rpr) table.set("offset", dyad.offset);
  if (dyad.type == DyadType::rpp) table.set_deg("slot_deg", dyad.slot);
  if (dyad.type != DyadType::prp && dyad.type != DyadType::rpp) {
    table.set_name("assembly", dyad.assembly);
  }
  if (!dyad.new_point.empty()) table.set("new", dyad.new_point);
  return table.set("names", dyad.names);
}

/// Writes what one key of a type holds.
template <class Type>
struct KeyWriter {
  TableWriter& table;
  std::string_view key;
  const Type& mechanism;

  void operator()(const PivotsKey<Type>& pivots) const {
    table.set(key, std::array{mechanism.*pivots.first, mechanism.*pivots.second});
  }
  void operator()(const DirectionKey<Type>& line) const { set_angle(mechanism.*line.of); }
  void operator()(const InclinationKey<Type>& line) const { set_angle(mechanism.*line.of); }
  void operator()(const AssemblyKey<Type>& assembly) const {
    table.set_name(key, mechanism.*assembly.of);
  }
  /// A number, or a point.
  template <class Other>
  void operator()(const Other& other) const {
    table.set(key, mechanism.*other.of);
  }

 private:
  void set_angle(const Vec2d& direction) const { table.set_deg(key, angle_of(direction)); }
};

/// The keys of `[mechanism]` other than its type.
template <class Type>
void write_description(const Type& mechanism, TableWriter& table) {
  for (const auto& key : TypeTraits<Type>::kKeys) {
    std::visit(KeyWriter<Type>{table, key.name, mechanism}, key.holds);
  }
}

void write_description(const ChainDescription& chain, TableWriter& table) {
  Array pivots, dyads;
  for (const auto& [name, at] : chain.pivots) {
    pivots.push_back(node(TableWriter{}.set("name", name).set("at", at)));
  }
  const bool slides = !std::holds_alternative<CrankDescription>(chain.drive);
  for (const DyadDescription& dyad : chain.dyads) {
    dyads.push_back(
        node(dyad.type == DyadType::group ? group_writer(dyad.group, slides) : dyad_writer(dyad)));
  }
  constexpr std::array<std::string_view, 3> kDrives{"crank", "slider", "cylinder"};
  if (!pivots.empty()) table.set("pivot", pivots);
  std::visit(
      [&](const auto& drive) {
        table.add(kDrives[chain.drive.index()], node(drive_writer(drive)));
      },
      chain.drive);
  if (!dyads.empty()) table.set("dyad", dyads);
}

/// Names the output of a chain where it is another body than the last, which it is by default.
void write_output(const NamedMechanism& mechanism, TableWriter& table) {
  const int last = static_cast<int>(mechanism.bodies.size()) - 1;
  const bool is_usual = mechanism.output <= 0 || mechanism.output >= last;
  if (mechanism.type() != MechanismType::chain || is_usual) return;
  table.set("output", mechanism.bodies[static_cast<std::size_t>(mechanism.output)]);
}

}  // namespace

TableWriter mechanism_writer(const NamedMechanism& mechanism) {
  TableWriter table;
  table.set_name("type", mechanism.type());
  std::visit([&](const auto& described) { write_description(described, table); },
             mechanism.description);
  write_output(mechanism, table);
  Array points;
  for (const PointDescription& point : mechanism.extra_points) {
    points.push_back(
        node(TableWriter{}
                 .set("name", point.name)
                 .add("on", point.on.size() == 1 ? node(point.on.front()) : node(point.on))
                 .set("at", point.at)));
  }
  if (!points.empty()) table.set("point", points);
  return table;
}

}  // namespace cognate::problems::reading
