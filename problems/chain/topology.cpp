#include "problems/chain/topology.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>

#include "analysis/numbers/angle.hpp"
#include "problems/chain/places.hpp"
#include "problems/chain/three_pin/group.hpp"
#include "synthesis/chain/sweep.hpp"
#include "synthesis/chain/transform.hpp"

namespace cognate::problems {
namespace {

using synthesis::ChainLine;
using synthesis::LineType;

/// The points of a chain with the crank at angle 0, which is computed as if its crank were of
/// length 1: products of many lengths leave the range of numbers otherwise.
std::vector<Vec2d> points_at_start(const Topology& topology, synthesis::ChainDesign design) {
  const auto lines = placed_lines(chain_of(topology));
  const auto crank = std::ranges::find(lines, LineType::crank,
                                       [](const auto& placed) { return placed.line.type; });
  const double unit = design.parameters[static_cast<std::size_t>(crank->parameter)];
  transform(lines, {1 / unit, 0}, {}, design.parameters);
  const std::vector<double> side(design.side.begin(), design.side.end());
  const synthesis::ChainView<double> view{lines.data(), static_cast<int>(lines.size()),
                                          design.parameters.data(), side.data()};
  synthesis::ChainPlace<double> place;
  synthesis::place_lines<synthesis::Kept::nothing>(view, Vec2d{1, 0}, place);
  std::vector<Vec2d> points(place.at, place.at + lines.size());
  for (Vec2d& point : points) point = unit * point;
  return points;
}

/// Adds the parts of a mechanism line by line.
class Naming {
 public:
  Naming(const Topology& topology, const synthesis::ChainDesign& design)
      : topology_(topology), design_(design), places_(chain_of(topology).lines, design.parameters) {
    mechanism_.bodies.resize(static_cast<std::size_t>(places_.body_count()));
    mechanism_.bodies[0] = "frame";
    const double* next = design.parameters.data();
    for (std::size_t i = 0; i < topology.lines.size(); ++i) {
      add(static_cast<int>(i), next, i < design.side.size() ? design.side[i] : 1);
      next += parameter_count(topology.lines[i].line.type);
    }
    mechanism_.output = places_.body_count() - 1;
    mechanism_.description = chain_;
  }

  NamedMechanism take() { return std::move(mechanism_); }

 private:
  const std::string& name(int line) const {
    return topology_.lines[static_cast<std::size_t>(line)].name;
  }

  Attached<double> place(int line) const {
    const auto [body, at] = places_.place(line);
    return {body, at};
  }

  void add(int index, const double* parameters, int side) {
    const ChainLine& line = topology_.lines[static_cast<std::size_t>(index)].line;
    if (is_point(line.type)) mechanism_.points.push_back({name(index), place(index)});
    switch (line.type) {
      case LineType::pivot:
        return chain_.pivots.push_back({name(index), {parameters[0], parameters[1]}});
      case LineType::crank:
        return add_crank(index, line, parameters[0]);
      case LineType::dyad:
        return add_dyad(index, line, parameters, side);
      case LineType::attached:
        return mechanism_.extra_points.push_back(
            {name(index), {name(line.first), name(line.second)}, {parameters[0], parameters[1]}});
      case LineType::guide:
        return guides_.push_back({index, {parameters[0], parameters[1]}});
      case LineType::slider:
        return add_slider(index, line, parameters[0], side);
      case LineType::third_pin:
        return add_three_pin_link(index);
      case LineType::heading:
        return;
      case LineType::third_link:
      case LineType::drawn:
      case LineType::first_pin:
      case LineType::second_pin:
        return;  // with the third pin
    }
  }

  void add_crank(int index, const ChainLine& line, double length) {
    const CrankDescription crank{name(line.first), name(index), length};
    mechanism_.mechanism.drive = Crank<double>{place(line.first).at, length};
    mechanism_.bodies[1] = crank.name;
    chain_.drive = crank;
  }

  void add_dyad(int index, const ChainLine& line, const double* lengths, int side) {
    DyadDescription dyad;
    dyad.joins = {name(line.first), name(line.second)};
    dyad.lengths = {lengths[0], lengths[1]};
    dyad.assembly = side < 0 ? Assembly::crossed : Assembly::open;
    dyad.new_point = name(index);
    dyad.names = link_names(name(line.first), name(line.second), name(index));
    auto& dyads = mechanism_.mechanism.dyads;
    std::ranges::copy(dyad.names, mechanism_.bodies.begin() + 2 * (std::ssize(dyads) + 1));
    dyads.push_back(
        Rrr<double>{place(line.first), place(line.second), lengths[0], lengths[1], dyad.assembly});
    chain_.dyads.push_back(std::move(dyad));
  }

  void add_slider(int index, const ChainLine& line, double length, int side) {
    const auto& guide = *std::ranges::find(guides_, line.second, &DrawnGuide::line);
    const int through = topology_.lines[static_cast<std::size_t>(guide.line)].line.first;
    DyadDescription dyad;
    dyad.type = DyadType::rrp;
    dyad.joins = {name(line.first)};
    dyad.lengths = {length};
    dyad.slides = {{name(through), guide.parameters.x, guide.parameters.y}};
    dyad.assembly = side < 0 ? Assembly::crossed : Assembly::open;
    dyad.new_point = name(index);
    dyad.names = slider_link_names(name(line.first), name(index));
    auto& dyads = mechanism_.mechanism.dyads;
    std::ranges::copy(dyad.names, mechanism_.bodies.begin() + 2 * (std::ssize(dyads) + 1));
    const Guide<double> on{0, place(through).at, unit_vector(guide.parameters.x),
                           guide.parameters.y};
    dyads.push_back(Rrp<double>{place(line.first), length, on, dyad.assembly});
    chain_.dyads.push_back(std::move(dyad));
  }

  void add_three_pin_link(int last) {
    auto [group, description] = three_pin_group(
        topology_, places_, last, points_at_start(topology_, design_), mechanism_.bodies);
    auto& dyads = mechanism_.mechanism.dyads;
    std::ranges::copy(description.names, mechanism_.bodies.begin() + 2 * (std::ssize(dyads) + 1));
    dyads.push_back(std::move(group));
    dyads.push_back(GroupRest{});
    chain_.dyads.push_back({.type = DyadType::group, .names = {}, .group = std::move(description)});
  }

  struct DrawnGuide {
    int line;
    Vec2d parameters;  ///< direction and offset
  };

  const Topology& topology_;
  const synthesis::ChainDesign& design_;
  ChainPlaces places_;
  std::vector<DrawnGuide> guides_;
  NamedMechanism mechanism_;
  ChainDescription chain_;
};

Vec2d named_place(const NamedMechanism& mechanism, const std::string& name) {
  const auto found = std::ranges::find(mechanism.points, name, &NamedPoint::name);
  return found == mechanism.points.end() ? Vec2d{} : found->at.at;
}

/// "CEF(B, D, G)".
std::string sketch_of_three_pins(const Topology& topology, const TopologyLine& point) {
  const auto name = [&](int line) { return topology.lines[static_cast<std::size_t>(line)].name; };
  const int last = point.line.second + 1;
  const auto from = [&](int line) {
    return name(topology.lines[static_cast<std::size_t>(line)].line.first);
  };
  return fmt::format("{}({}, {}, {})", three_pin_names(topology, last).back(), from(last - 2),
                     from(last - 1), from(last - synthesis::kThirdPin));
}

/// "C(B, D)", "E on BC".
std::string sketch_of(const Topology& topology, const TopologyLine& point) {
  const auto name = [&](int line) { return topology.lines[static_cast<std::size_t>(line)].name; };
  const auto& [type, first, second] = point.line;
  switch (type) {
    case LineType::pivot:
      return "";
    case LineType::crank:
      return fmt::format("crank {}", link_name(name(first), point.name));
    case LineType::dyad:
      return fmt::format("{}({}, {})", point.name, name(first), name(second));
    case LineType::attached:
      return fmt::format("{} on {}", point.name, link_name(name(first), name(second)));
    case LineType::guide:
      return "";
    case LineType::slider:
      return fmt::format("slider {}({})", point.name, name(first));
    case LineType::third_pin:
      return sketch_of_three_pins(topology, point);
    case LineType::heading:
    case LineType::third_link:
    case LineType::drawn:
    case LineType::first_pin:
    case LineType::second_pin:
      return "";
  }
  return "";
}

}  // namespace

std::string sketch(const Topology& topology) {
  std::string text;
  for (const TopologyLine& point : topology.lines) {
    const std::string line = sketch_of(topology, point);
    if (!line.empty()) text += (text.empty() ? "" : "; ") + line;
  }
  return text;
}

std::string link_name(const std::string& first, const std::string& second) {
  const bool letters = first.size() == 1 && second.size() == 1;
  return letters ? first + second : fmt::format("{}-{}", first, second);
}

std::array<std::string, 2> link_names(const std::string& first, const std::string& second,
                                      const std::string& joint) {
  return {link_name(first, joint), link_name(joint, second)};
}

std::string guide_name(const std::string& pin) {
  return pin + "-slide";
}

std::string third_link_name(const std::string& first, const std::string& third) {
  return link_name(first, third) + "-link";
}

std::string drawn_name(const std::string& pin) {
  return pin + "-drawn";
}

bool is_point(LineType type) {
  return type != LineType::guide && type != LineType::heading && type != LineType::third_link &&
         type != LineType::drawn;
}

std::array<std::string, 2> slider_link_names(const std::string& first, const std::string& pin) {
  return {link_name(first, pin), "slider-" + pin};
}

std::vector<std::vector<std::string>> links_of(std::span<const Topology> topologies) {
  std::vector<std::vector<std::string>> all;
  for (const Topology& topology : topologies) {
    const auto name = [&](int line) { return topology.lines[static_cast<std::size_t>(line)].name; };
    auto& links = all.emplace_back();
    for (const TopologyLine& point : topology.lines) {
      const auto& [type, first, second] = point.line;
      if (type == LineType::crank) links.push_back(CrankDescription{}.name);
      if (type == LineType::dyad) {
        std::ranges::copy(link_names(name(first), name(second), point.name),
                          std::back_inserter(links));
      }
      if (type == LineType::slider) {
        std::ranges::copy(slider_link_names(name(first), point.name), std::back_inserter(links));
      }
      if (type == LineType::third_pin) {
        std::ranges::copy(three_pin_names(topology, second + 1), std::back_inserter(links));
      }
    }
  }
  return all;
}

bool has_three_pin_link(const Topology& topology) {
  return std::ranges::any_of(topology.lines, [](const TopologyLine& line) {
    return line.line.type == LineType::third_link;
  });
}

int link_count(const Topology& topology) {
  return 1 + static_cast<int>(links_of({&topology, 1}).front().size());
}

synthesis::Chain chain_of(const Topology& topology) {
  synthesis::Chain chain;
  for (const TopologyLine& point : topology.lines) chain.lines.push_back(point.line);
  return chain;
}

NamedMechanism named(const Topology& topology, const synthesis::ChainDesign& design) {
  return Naming(topology, design).take();
}

std::optional<int> slider_dyad(const NamedMechanism& mechanism, const std::string& pin) {
  const auto& rows = std::get<ChainDescription>(mechanism.description).dyads;
  const auto found = std::ranges::find(rows, pin, &DyadDescription::new_point);
  if (found == rows.end() || found->type != DyadType::rrp) return std::nullopt;
  auto before = std::ranges::count(rows.begin(), found, DyadType::rrp, &DyadDescription::type);
  const auto& dyads = mechanism.mechanism.dyads;
  for (std::size_t i = 0; i < dyads.size(); ++i) {
    if (std::holds_alternative<Rrp<double>>(dyads[i]) && before-- == 0) return static_cast<int>(i);
  }
  return std::nullopt;
}

std::optional<Guide<double>> guide_of(const NamedMechanism& mechanism, const std::string& pin) {
  const auto dyad = slider_dyad(mechanism, pin);
  if (!dyad) return std::nullopt;
  return std::get<Rrp<double>>(mechanism.mechanism.dyads[static_cast<std::size_t>(*dyad)]).guide;
}

synthesis::ChainDesign dimensions(const Topology& topology, const NamedMechanism& mechanism) {
  synthesis::ChainDesign design;
  const auto lines = chain_of(topology).lines;
  std::size_t dyads = 0;
  const auto add = [&](std::initializer_list<double> parameters, int side = 0) {
    design.parameters.insert(design.parameters.end(), parameters);
    design.side.push_back(side);
  };
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto& [type, first, second] = lines[i];
    const Vec2d at = named_place(mechanism, topology.lines[i].name);
    if (type == LineType::pivot) {
      add({at.x, at.y});
    } else if (type == LineType::crank) {
      add({std::get<Crank<double>>(mechanism.mechanism.drive).length});
    } else if (type == LineType::guide) {
      add({0, 0});
    } else if (type == LineType::slider) {
      const auto& dyad = std::get<Rrp<double>>(mechanism.mechanism.dyads[dyads++]);
      const auto place = placed_lines(chain_of(topology))[static_cast<std::size_t>(second)];
      design.parameters[static_cast<std::size_t>(place.parameter)] = angle_of(dyad.guide.direction);
      design.parameters[static_cast<std::size_t>(place.parameter) + 1] = dyad.guide.offset;
      add({dyad.length}, dyad.assembly == Assembly::open ? 1 : -1);
    } else if (type == LineType::dyad) {
      const auto& dyad = std::get<Rrr<double>>(mechanism.mechanism.dyads[dyads++]);
      add({dyad.first_length, dyad.second_length}, dyad.assembly == Assembly::open ? 1 : -1);
    } else if (type == LineType::third_link) {
      const auto own = three_pin_parameters(std::get<Group>(mechanism.mechanism.dyads[dyads]));
      dyads += 2;
      design.parameters.insert(design.parameters.end(), own.begin(), own.end());
      design.side.push_back(0);
    } else if (type == LineType::drawn || is_three_pin(type)) {
      design.side.push_back(0);  // with the first line of the link
    } else {
      const ChainPlaces places(std::span<const ChainLine>(lines).first(i), design.parameters);
      const Vec2d local = places.in_axes(first, second, at);
      add({local.x, local.y});
    }
  }
  return design;
}

}  // namespace cognate::problems
