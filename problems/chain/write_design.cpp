#include "problems/chain/write_design.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "problems/basics/degrees.hpp"
#include "problems/chain/read_parts.hpp"
#include "problems/linkage/write_linkage.hpp"

namespace cognate::problems::reading {
namespace {

using synthesis::LineType;

Node dimension_node(const std::optional<double>& given) {
  return given ? node(*given) : node(kFreeDimension);
}

/// Adds what is given of `line` to its table.
void write_given(const TopologyLine& line, TableWriter& table) {
  const auto& [first, second] = line.given;
  if (parameter_count(line.line.type) == 1) {
    table.set("length", first);
  } else if (first || second) {
    table.add(line.line.type == LineType::dyad ? "lengths" : "at",
              node(Array{dimension_node(first), dimension_node(second)}));
  }
  if (is_dyad(line.line.type)) table.set_name("assembly", line.assembly);
}

/// `slide` of a slider; `through` is the pivot from which the guide's offset counts, empty where
/// the topology has its own.
Node slide_node(const TopologyLine& guide, const std::string& through) {
  TableWriter slide;
  const auto& [direction, offset] = guide.given;
  if (!through.empty()) slide.set("through", through);
  if (direction) slide.set("direction_deg", degrees(*direction));
  if (offset || !through.empty()) slide.add("offset", dimension_node(offset));
  return node(slide.take());
}

bool has_given(const TopologyLine& line) {
  return line.given[0] || line.given[1] || line.assembly;
}

class PartsWriter {
 public:
  explicit PartsWriter(const Topology& topology) : topology_(topology) {}

  /// Adds `line` with the points that it closes on.
  void add_whole(const TopologyLine& line) {
    TableWriter table;
    const auto& [type, first, second] = line.line;
    if (type == LineType::crank) table.set("at", name(first)).set("pin", line.name);
    if (type == LineType::dyad) table.set("joins", std::array{name(first), name(second)});
    if (type == LineType::attached) table.set("on", std::array{name(first), name(second)});
    if (type == LineType::slider) {
      const TopologyLine& guide = topology_.lines[static_cast<std::size_t>(second)];
      table.set("type", "RRP").set("joins", name(first));
      table.add("slide", slide_node(guide, name(guide.line.first)));
    }
    if (type == LineType::third_pin) add_three_pins(line, table);
    if (is_point(type) && !is_three_pin(type)) add(line, table);
  }

  /// Adds what is given of it alone.
  void add_given(const TopologyLine& line) {
    TableWriter table;
    if (!is_point(line.line.type)) return;
    bool has_guide = false;
    if (line.line.type == LineType::slider) {
      const TopologyLine& guide =
          *std::ranges::find(topology_.lines, guide_name(line.name), &TopologyLine::name);
      has_guide = has_given(guide);
      if (has_guide) table.add("slide", slide_node(guide, ""));
    }
    if (has_guide || has_given(line)) add(line, table);
  }

  void write(TableWriter& mechanism) {
    if (!pivots_.empty()) mechanism.set("pivot", pivots_);
    if (!crank_.empty()) mechanism.add("crank", node(crank_));
    if (!dyads_.empty()) mechanism.set("dyad", dyads_);
    if (!points_.empty()) mechanism.set("point", points_);
  }

 private:
  void add_three_pins(const TopologyLine& line, TableWriter& table) {
    const auto& [type, first, second] = line.line;
    const auto held_from = [&](int of) {
      return name(topology_.lines[static_cast<std::size_t>(of)].line.first);
    };
    table.set("type", kThreePinWord)
        .set("joins", std::array{held_from(first), held_from(second),
                                 held_from(first - synthesis::kFirstPin)})
        .set("new", std::array{name(first), name(second), line.name});
    dyads_.push_back(node(table.take()));
  }

  std::string name(int line) const {
    const auto at = static_cast<std::size_t>(line);
    return at < topology_.lines.size() ? topology_.lines[at].name : "";
  }

  void add(const TopologyLine& line, TableWriter& table) {
    const LineType type = line.line.type;
    if (is_dyad(type)) table.set("new", line.name);
    if (type == LineType::pivot || type == LineType::attached) table.set("name", line.name);
    write_given(line, table);
    if (type == LineType::crank) {
      crank_ = table.take();
    } else {
      (type == LineType::pivot ? pivots_
       : is_dyad(type)         ? dyads_
                               : points_)
          .push_back(node(table.take()));
    }
  }

  const Topology& topology_;
  Array pivots_, dyads_, points_;
  Table crank_;
};

/// The points of all topologies, each name once.
Topology merged(const std::vector<Topology>& topologies) {
  Topology all;
  for (const Topology& topology : topologies) {
    for (const TopologyLine& line : topology.lines) {
      const auto found = std::ranges::find(all.lines, line.name, &TopologyLine::name);
      if (found == all.lines.end()) all.lines.push_back(line);
    }
  }
  return all;
}

bool is_bounded(const Range& range) {
  return std::isfinite(range.min) || std::isfinite(range.max);
}

Range length_bound(const Range& range) {
  return {std::max(0.0, range.min), range.max};
}

bool same_range(const Range& a, const Range& b) {
  return a.min == b.min && a.max == b.max;
}

/// Whether two topologies demand the same of their points of one name, as a file does.
bool demands_same(const TopologyLine& a, const TopologyLine& b) {
  return a.line.type == b.line.type && a.given == b.given && a.assembly == b.assembly &&
         std::ranges::equal(a.bounds, b.bounds, same_range);
}

bool same_structure(const Topology& a, const Topology& b) {
  const auto same_line = [](const TopologyLine& x, const TopologyLine& y) {
    return x.name == y.name && x.line.type == y.line.type && x.line.first == y.line.first &&
           x.line.second == y.line.second;
  };
  return a.trace == b.trace && std::ranges::equal(a.lines, b.lines, same_line);
}

}  // namespace

TableWriter chain_mechanism_writer(const std::string& type,
                                   const std::vector<Topology>& topologies) {
  TableWriter table;
  table.set("type", type);
  const bool whole = type == kChainWord && topologies.size() == 1;
  const Topology all = whole ? topologies.front() : merged(topologies);
  PartsWriter parts(all);
  for (const TopologyLine& line : all.lines) {
    whole ? parts.add_whole(line) : parts.add_given(line);
  }
  parts.write(table);
  return table;
}

TableWriter chain_bounds_writer(const std::vector<Topology>& topologies) {
  TableWriter table;
  for (const auto& [name, line, given, bounds, assembly] : merged(topologies).lines) {
    const auto& [first, second] = bounds;
    if (!is_bounded(first) && !is_bounded(second)) continue;
    if (parameter_count(line.type) == 1) {
      table.set(name, length_bound(first));
    } else if (line.type == LineType::guide) {
      table.set(name, second);
    } else if (has_lengths(line.type)) {
      table.set(name, std::array{length_bound(first), length_bound(second)});
    } else {
      table.set(name, Box{{first.min, second.min}, {first.max, second.max}});
    }
  }
  return table;
}

TableWriter chain_solve_writer(const Solve& solve, const std::optional<ChainMeasure>& against) {
  Solve usual;
  usual.starts = solve.starts;
  usual.designs = solve.designs;
  Table written = solve_writer(solve).take();
  const bool is_usual = solve.solver == usual.solver;
  if (is_usual) std::erase_if(written, [](const Entry& entry) { return entry.key == "solver"; });
  if (against == ChainMeasure::links) {
    std::erase_if(written, [](const Entry& entry) { return entry.key == "designs"; });
  }
  TableWriter table = TableWriter{}.append(std::move(written));
  if (!against) return table;
  return std::move(table).set("objectives", Array{node("error"), node(to_string(*against))});
}

TableWriter chain_constraints_writer(const ChainConstraints& constraints) {
  TableWriter table;
  table.set_deg("transmission_angle_deg", constraints.transmission_angle)
      .set_name("over", constraints.over)
      .set("rms_error_max", constraints.rms_error_max);
  return table;
}

void write_chain_timing(const std::vector<double>& angles, TableWriter& target) {
  target.set("timing", angles.empty() ? kFreeDimension : "prescribed");
  if (angles.empty()) return;
  Array degrees;
  for (const double angle : angles) degrees.push_back(node_deg(angle));
  target.set("crank_deg", degrees);
}

void write_traced(const std::string& type, const std::vector<Topology>& topologies,
                  TableWriter& target) {
  if (type != kChainWord || topologies.size() != 1) return;
  const Topology& topology = topologies.front();
  const auto trace = static_cast<std::size_t>(topology.trace);
  if (trace < topology.lines.size()) target.set("point", topology.lines[trace].name);
}

void check_one_demand(const std::vector<Topology>& topologies, std::vector<std::string>& faults) {
  const Topology all = merged(topologies);
  for (const Topology& topology : topologies) {
    for (const TopologyLine& line : topology.lines) {
      const auto first = std::ranges::find(all.lines, line.name, &TopologyLine::name);
      if (demands_same(*first, line)) continue;
      faults.push_back(
          fmt::format("the topologies differ in what they demand of {}; expected the "
                      "same of each",
                      line.name));
      return;
    }
  }
}

void check_structure(const std::string& type, const std::vector<Topology>& topologies,
                     const std::vector<Topology>& known, std::vector<std::string>& faults) {
  if (type == kChainWord) {
    if (topologies.size() == 1) return;
    faults.push_back(
        fmt::format("{} topologies are given for a chain; expected one", topologies.size()));
  } else if (!std::ranges::equal(topologies, known, same_structure)) {
    faults.push_back(fmt::format(
        "the topologies are not those of \"{0}\"; expected those that \"{0}\" stands for", type));
  }
}

}  // namespace cognate::problems::reading
