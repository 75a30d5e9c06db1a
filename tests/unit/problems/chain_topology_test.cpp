/// Topologies as mechanisms: positions against circles intersected point by point, and back.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "analysis/mechanism/kinematics.hpp"
#include "problems/chain/topology.hpp"

namespace cognate::problems::chain_topology_test {
namespace {

using synthesis::ChainDesign;
using synthesis::LineType;

constexpr std::string_view kAll[] = {"stephenson-3", "watt-1",      "watt-1-hf",   "eight-bar-1",
                                     "eight-bar-2",  "eight-bar-3", "eight-bar-4", "eight-bar-5"};

std::vector<Topology> all_with_sliders() {
  auto all = topologies("slider-crank");
  std::ranges::copy(function_topologies("slider-crank"), std::back_inserter(all));
  std::ranges::copy(function_topologies("six-bar-slider"), std::back_inserter(all));
  return all;
}

/// Pivots and lengths with which every topology assembles over a part of the turn.
std::vector<double> parameters_of(const TopologyLine& line) {
  static const std::map<std::string, std::vector<double>> known{
      {"A", {0.5, -0.25}}, {"D", {4, 0.5}},          {"B", {1}},
      {"C", {3.5, 4}},     {"E", {1.5, 2}},          {"G", {-1.5, 5}},
      {"F", {6, 5}},       {"H", {2, -1.5}},         {"K", {2.5, 1.5}},
      {"L", {0.5, 7}},     {"N", {1.25, -0.5}},      {"J", {7, 6.5}},
      {"P", {-1, 2.25}},   {"C-slide", {0.3, -0.4}}, {"F-slide", {-0.6, 1.5}}};
  auto values = known.at(line.name);
  values.resize(static_cast<std::size_t>(parameter_count(line.line.type)));
  return values;
}

ChainDesign design_of(const Topology& topology, bool mirrored) {
  ChainDesign design;
  for (const TopologyLine& line : topology.lines) {
    const auto values = parameters_of(line);
    design.parameters.insert(design.parameters.end(), values.begin(), values.end());
    design.side.push_back(!is_dyad(line.line.type) ? 0 : line.name == "F" && mirrored ? -1 : 1);
  }
  return design;
}

/// Of a guide.
Vec2d direction_of(const Topology& topology, const ChainDesign& design, int line) {
  const int place = placed_lines(chain_of(topology))[std::size_t(line)].parameter;
  const double angle = design.parameters[std::size_t(place)];
  return {std::cos(angle), std::sin(angle)};
}

/// Every point at a crank angle; empty where a dyad does not close.
std::vector<Vec2d> places(const Topology& topology, const ChainDesign& design, double angle) {
  std::vector<Vec2d> all;
  const double* parameter = design.parameters.data();
  for (std::size_t i = 0; i < topology.lines.size(); ++i) {
    const auto& [type, first, second] = topology.lines[i].line;
    const double u = parameter[0], v = parameter_count(type) == 1 ? 0 : parameter[1];
    parameter += parameter_count(type);
    const Vec2d p = first < 0 ? Vec2d{} : all[std::size_t(first)];
    const Vec2d way = second < 0 ? Vec2d{1, 0} : all[std::size_t(second)] - p;
    const double distance = norm(way);
    if (type == LineType::pivot) {
      all.push_back({u, v});
    } else if (type == LineType::crank) {
      all.push_back(p + u * Vec2d{std::cos(angle), std::sin(angle)});
    } else if (type == LineType::guide) {
      // The foot of the pivot; the direction stands in its own parameter.
      all.push_back(p + v * Vec2d{-std::sin(u), std::cos(u)});
    } else if (type == LineType::slider) {
      const Vec2d along = direction_of(topology, design, second);
      const double ahead = dot(along, p - all[std::size_t(second)]);
      const Vec2d foot = all[std::size_t(second)] + ahead * along;
      const double square = u * u - squared_norm(foot - p);
      if (square < 0) return {};
      all.push_back(foot + (design.side[i] * std::sqrt(square)) * along);
    } else if (type == LineType::attached) {
      all.push_back(p + (1 / distance) * (way * Vec2d{u, v}));
    } else {
      const double along = (u * u - v * v + distance * distance) / (2 * distance);
      const double height2 = u * u - along * along;
      if (height2 < 0) return {};
      all.push_back(p + (1 / distance) * (way * Vec2d{along, design.side[i] * std::sqrt(height2)}));
    }
  }
  return all;
}

void expect_same_places(const Topology& topology, const ChainDesign& design) {
  const NamedMechanism mechanism = named(topology, design);
  MechanismMotion<0> motion(mechanism.mechanism);
  int compared = 0;
  for (int step = 0; step < 72; ++step) {
    const double angle = 0.1 + step * 0.0872664625997;
    const auto wanted = places(topology, design, angle);
    ASSERT_EQ(motion.move_to(angle), !wanted.empty()) << topology.name << " at " << angle;
    if (wanted.empty()) continue;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      if (topology.lines[i].line.type == LineType::guide) continue;
      const auto found =
          std::ranges::find(mechanism.points, topology.lines[i].name, &NamedPoint::name);
      ASSERT_NE(found, mechanism.points.end()) << topology.lines[i].name;
      const NamedPoint& point = *found;
      const auto& body = motion.bodies()[std::size_t(point.at.body)];
      EXPECT_LT(norm(point_motion(body, point.at.at)[0] - wanted[i]), 1e-12) << point.name;
      ++compared;
    }
  }
  EXPECT_GT(compared, 100) << topology.name;
}

TEST(ChainTopology, MechanismsAreWhereTheirPointsClose) {
  for (const std::string_view word : kAll) {
    const auto all = topologies(word);
    ASSERT_EQ(all.size(), 1U) << word;
    for (const bool mirrored : {false, true}) {
      expect_same_places(all[0], design_of(all[0], mirrored));
    }
  }
}

TEST(ChainTopology, SlidersAreWhereTheirPointsClose) {
  for (const Topology& topology : all_with_sliders()) {
    for (const bool mirrored : {false, true}) {
      expect_same_places(topology, design_of(topology, mirrored));
    }
  }
}

TEST(ChainTopology, DimensionsAreReadBack) {
  auto all = topologies("any");
  std::ranges::copy(all_with_sliders(), std::back_inserter(all));
  for (const Topology& topology : all) {
    const ChainDesign design = design_of(topology, true);
    const ChainDesign back = dimensions(topology, named(topology, design));
    EXPECT_EQ(back.side, design.side) << topology.name;
    ASSERT_EQ(back.parameters.size(), design.parameters.size()) << topology.name;
    for (std::size_t i = 0; i < design.parameters.size(); ++i) {
      EXPECT_NEAR(back.parameters[i], design.parameters[i], 1e-13) << topology.name << " " << i;
    }
  }
}

TEST(ChainTopology, WordsStandForOneOrSeveral) {
  EXPECT_EQ(topologies("six-bar").size(), 3U);
  EXPECT_EQ(topologies("eight-bar").size(), 5U);
  EXPECT_EQ(topologies("any").size(), 9U);
  EXPECT_EQ(function_topologies("six-bar").size(), 2U);
  EXPECT_EQ(function_topologies("six-bar-slider").size(), 2U);
  EXPECT_TRUE(topologies("four-bar").empty()) << "is a kind of its own";
  EXPECT_TRUE(topologies("watt-3").empty());
  for (const TopologyWord& word : topology_words()) {
    EXPECT_FALSE(topologies(word.word).empty()) << word.word;
  }
}

TEST(ChainTopology, NamesMeanTheSameInAllTopologies) {
  std::map<std::string, LineType> types;
  for (const Topology& topology : topologies("any")) {
    EXPECT_EQ(topology.lines[std::size_t(topology.trace)].name, "P");
    for (const TopologyLine& line : topology.lines) {
      EXPECT_EQ(types.emplace(line.name, line.line.type).first->second, line.line.type);
    }
  }
}

TEST(ChainTopology, SketchSaysHowItCloses) {
  EXPECT_EQ(sketch(topologies("stephenson-3")[0]), "crank AB; C(B, D); E on BC; F(E, G); P on EF");
  EXPECT_EQ(sketch(topologies("slider-crank")[0]), "crank AB; slider C(B); P on BC");
}

}  // namespace
}  // namespace cognate::problems::chain_topology_test
