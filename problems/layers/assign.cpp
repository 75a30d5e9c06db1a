#include "problems/layers/assign.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "analysis/layers/collisions.hpp"
#include "analysis/layers/stacking.hpp"
#include "problems/mechanism/joint_names.hpp"

namespace cognate::problems {
namespace {

constexpr std::size_t kMostPins = 64;

LinkSet bit(int link) {
  return LinkSet{1} << link;
}

/// A link, or a pin.
struct Part {
  int number = 0;
  bool is_pin = false;
};

class LayerAssigner {
 public:
  LayerAssigner(const NamedMechanism& mechanism, const AssemblyRanges& motion,
                const LayerSizes& sizes)
      : mechanism_(mechanism),
        motion_(motion),
        clearance_(sizes.clearance),
        plates_(cognate::plates(mechanism.mechanism, motion, points_of(mechanism),
                                plate_sizes(mechanism, sizes))),
        joint_names_(joint_names(mechanism)) {}

  tl::expected<LayerResult, std::string> assign(const std::function<bool()>& stop) {
    const std::size_t links = plates_.links.size();
    if (links > kMostStackedLinks || plates_.pins.size() > kMostPins) {
      return tl::unexpected(
          fmt::format("the links have no layers: there are {}, and at most {} can be layered",
                      links, kMostStackedLinks));
    }
    stack_.apart.assign(links, 0);
    for (const PlatePin& pin : plates_.pins) add_pin(pin);
    for (const auto& [a, b] : plates_.slides) keep_apart(a, b, LayerConflictKind::slide);
    if (!add_collisions(stop)) {
      return tl::unexpected(std::string(
          "the links have no layers: the time limit came before their collisions were known"));
    }
    report(fewest_layers(stack_));
    return std::move(result_);
  }

 private:
  static std::vector<Attached<double>> points_of(const NamedMechanism& mechanism) {
    std::vector<Attached<double>> points;
    for (const NamedPoint& point : mechanism.points) points.push_back(point.at);
    return points;
  }

  const Plate& plate(const Part& part) const {
    const auto number = static_cast<std::size_t>(part.number);
    return part.is_pin ? plates_.pins[number].disc : plates_.links[number];
  }
  const std::string& name(const Part& part) const {
    const auto number = static_cast<std::size_t>(part.number);
    return part.is_pin ? joint_names_[static_cast<std::size_t>(plates_.pins[number].joint)]
                       : mechanism_.bodies[static_cast<std::size_t>(plates_.links[number].body)];
  }

  void add_pin(const PlatePin& given) {
    StackPin pin{.on_base = given.on_base};
    for (const int link : given.links) pin.links |= bit(link);
    stack_.pins.push_back(pin);
    for (const int a : given.links) {
      for (const int b : given.links) {
        if (a < b) keep_apart(a, b, LayerConflictKind::joint);
      }
    }
  }

  void keep_apart(int a, int b, LayerConflictKind kind) {
    LinkSet& apart = stack_.apart[static_cast<std::size_t>(a)];
    if (apart & bit(b)) return;
    apart |= bit(b);
    stack_.apart[static_cast<std::size_t>(b)] |= bit(a);
    result_.conflicts.push_back({.first = name({a}), .second = name({b}), .kind = kind});
  }

  /// Everything that could be in one layer.
  std::vector<std::pair<Part, Part>> candidates() const {
    std::vector<std::pair<Part, Part>> all;
    const int links = static_cast<int>(plates_.links.size());
    const int pins = static_cast<int>(plates_.pins.size());
    for (int a = 0; a < links; ++a) {
      for (int b = a + 1; b < links; ++b) {
        if (!(stack_.apart[static_cast<std::size_t>(a)] & bit(b))) all.push_back({{a}, {b}});
      }
    }
    for (int p = 0; p < pins; ++p) {
      const LinkSet joined = stack_.pins[static_cast<std::size_t>(p)].links;
      for (int link = 0; link < links; ++link) {
        if (!(joined & bit(link))) all.push_back({{p, true}, {link}});
      }
      for (int q = p + 1; q < pins; ++q) all.push_back({{p, true}, {q, true}});
    }
    return all;
  }

  /// False where `stop` ended the search.
  bool add_collisions(const std::function<bool()>& stop) {
    const auto parts = candidates();
    std::vector<PlatePair> pairs;
    for (const auto& [a, b] : parts) pairs.push_back({&plate(a), &plate(b)});
    const Collisions found =
        find_collisions(mechanism_.mechanism, motion_, pairs, clearance_, stop);
    result_.cells = found.cells;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (found.pairs[i].passage == Passage::free) continue;
      const auto& [a, b] = parts[i];
      const auto kind = found.pairs[i].passage == Passage::collides ? LayerConflictKind::collision
                                                                    : LayerConflictKind::unresolved;
      result_.conflicts.push_back(
          {name(a), name(b), a.is_pin, b.is_pin, kind, found.pairs[i].drive});
      keep_apart(a, b);
    }
    return found.complete;
  }

  void keep_apart(const Part& a, const Part& b) {
    const auto first = static_cast<std::size_t>(a.number),
               second = static_cast<std::size_t>(b.number);
    if (b.is_pin) {
      stack_.pins[first].pins_hit |= std::uint64_t{1} << second;
      stack_.pins[second].pins_hit |= std::uint64_t{1} << first;
    } else if (a.is_pin) {
      stack_.pins[first].stops_at |= bit(b.number);
    } else {
      stack_.apart[first] |= bit(b.number);
      stack_.apart[second] |= bit(a.number);
    }
  }

  void report(const Stack& stack) {
    result_.tried = stack.tried;
    if (!stack.layers.empty()) result_.count = stack.count;
    for (std::size_t i = 0; i < plates_.links.size(); ++i) {
      const Part link{static_cast<int>(i)};
      result_.links.push_back(
          {name(link), 2 * plates_.links[i].radius, stack.layers.empty() ? 0 : stack.layers[i]});
      if (stack.blocked & bit(link.number)) result_.blocked.push_back(name(link));
    }
    for (std::size_t i = 0; i < plates_.pins.size(); ++i) report_pin(static_cast<int>(i), stack);
  }

  void report_pin(int number, const Stack& stack) {
    const PlatePin& pin = plates_.pins[static_cast<std::size_t>(number)];
    LayerResult::Pin row{name({number, true}), {}, {}};
    if (pin.on_base) row.joins.push_back(mechanism_.bodies.front());
    for (const int link : pin.links) row.joins.push_back(name({link}));
    if (!stack.layers.empty()) {
      std::vector<int> held;
      for (const int link : pin.links) held.push_back(stack.layers[static_cast<std::size_t>(link)]);
      const auto [low, high] = std::ranges::minmax(held);
      for (int layer = pin.on_base ? 1 : low; layer < high; ++layer) {
        if (std::ranges::find(held, layer) == held.end()) row.crosses.push_back(layer);
      }
    }
    result_.pins.push_back(std::move(row));
  }

  const NamedMechanism& mechanism_;
  const AssemblyRanges& motion_;
  double clearance_;
  Plates plates_;
  std::vector<std::string> joint_names_;
  StackProblem stack_;
  LayerResult result_;
};

}  // namespace

std::vector<Quantity> layer_quantities(const LayerResult& layers) {
  if (!layers.count) return {};
  double crossings = 0;
  for (const auto& pin : layers.pins) crossings += static_cast<double>(pin.crosses.size());
  return {{"layers.count", static_cast<double>(*layers.count)},
          {"layers.pin_crossings", crossings}};
}

PlateSizes plate_sizes(const NamedMechanism& mechanism, const LayerSizes& sizes) {
  PlateSizes plates{std::vector<double>(mechanism.bodies.size(), sizes.link_width),
                    sizes.pin_diameter, sizes.clearance};
  for (const auto& [link, width] : sizes.widths) {
    const auto body = std::ranges::find(mechanism.bodies, link);
    if (body == mechanism.bodies.end()) continue;  // a link of another mechanism of the search
    plates.widths[static_cast<std::size_t>(body - mechanism.bodies.begin())] = width;
  }
  return plates;
}

tl::expected<LayerResult, std::string> assign_layers(const NamedMechanism& mechanism,
                                                     const AssemblyRanges& motion,
                                                     const LayerSizes& sizes,
                                                     const std::function<bool()>& stop) {
  return LayerAssigner(mechanism, motion, sizes).assign(stop);
}

}  // namespace cognate::problems
