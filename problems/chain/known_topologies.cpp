/// The topologies that files know by a word.
#include <algorithm>
#include <array>
#include <span>

#include "problems/chain/topology.hpp"

namespace cognate::problems {
namespace {

using synthesis::ChainLine;
using synthesis::LineType;

/// A point of the table, by the names of the points that it closes on.
struct PointRow {
  std::string_view name;
  LineType type;
  std::string_view first, second;
};

using Rows = std::span<const PointRow>;

constexpr PointRow kFourBar[] = {{"A", LineType::pivot, "", ""},
                                 {"D", LineType::pivot, "", ""},
                                 {"B", LineType::crank, "A", ""},
                                 {"C", LineType::dyad, "B", "D"}};
constexpr PointRow kStephenson[] = {{"E", LineType::attached, "B", "C"},
                                    {"G", LineType::pivot, "", ""},
                                    {"F", LineType::dyad, "E", "G"}};
constexpr PointRow kWatt[] = {{"E", LineType::attached, "B", "C"},
                              {"H", LineType::attached, "D", "C"},
                              {"F", LineType::dyad, "E", "H"}};
constexpr PointRow kSecondFourBar[] = {{"E", LineType::attached, "D", "C"},
                                       {"G", LineType::pivot, "", ""},
                                       {"F", LineType::dyad, "E", "G"}};
constexpr PointRow kToFrame[] = {{"K", LineType::attached, "E", "F"},
                                 {"L", LineType::pivot, "", ""},
                                 {"J", LineType::dyad, "K", "L"}};
constexpr PointRow kToSecondLink[] = {{"K", LineType::attached, "E", "F"},
                                      {"N", LineType::attached, "G", "F"},
                                      {"J", LineType::dyad, "K", "N"}};
constexpr PointRow kToRockerLink[] = {{"K", LineType::attached, "E", "F"},
                                      {"N", LineType::attached, "H", "F"},
                                      {"J", LineType::dyad, "K", "N"}};
constexpr PointRow kToCoupler[] = {{"K", LineType::attached, "E", "F"},
                                   {"N", LineType::attached, "B", "C"},
                                   {"J", LineType::dyad, "K", "N"}};
constexpr PointRow kOnBC[] = {{"P", LineType::attached, "B", "C"}};
constexpr PointRow kOnEF[] = {{"P", LineType::attached, "E", "F"}};
constexpr PointRow kOnHF[] = {{"P", LineType::attached, "H", "F"}};
constexpr PointRow kOnKJ[] = {{"P", LineType::attached, "K", "J"}};

constexpr PointRow kKlann[] = {
    {"O", LineType::pivot, "", ""},  {"A", LineType::pivot, "", ""},
    {"B", LineType::pivot, "", ""},  {"M", LineType::crank, "O", ""},
    {"C", LineType::dyad, "M", "A"}, {"D", LineType::attached, "M", "C"},
    {"E", LineType::dyad, "D", "B"}, {"F", LineType::attached, "D", "E"}};
constexpr PointRow kJansen[] = {
    {"O", LineType::pivot, "", ""},      {"B", LineType::pivot, "", ""},
    {"M", LineType::crank, "O", ""},     {"C", LineType::dyad, "M", "B"},
    {"E", LineType::attached, "B", "C"}, {"D", LineType::dyad, "M", "B"},
    {"F", LineType::dyad, "E", "D"},     {"P", LineType::attached, "F", "D"}};

constexpr PointRow kSliderCrank[] = {{"A", LineType::pivot, "", ""},
                                     {"B", LineType::crank, "A", ""},
                                     {"C-slide", LineType::guide, "A", ""},
                                     {"C", LineType::slider, "B", "C-slide"}};

constexpr PointRow kCouplerSlider[] = {{"E", LineType::attached, "B", "C"},
                                       {"F-slide", LineType::guide, "A", ""},
                                       {"F", LineType::slider, "E", "F-slide"}};
constexpr PointRow kRockerSlider[] = {{"E", LineType::attached, "D", "C"},
                                      {"F-slide", LineType::guide, "A", ""},
                                      {"F", LineType::slider, "E", "F-slide"}};

constexpr PointRow kThreePinsOnFrame[] = {{"A", LineType::pivot, "", ""},
                                          {"D", LineType::pivot, "", ""},
                                          {"G", LineType::pivot, "", ""},
                                          {"B", LineType::crank, "A", ""},
                                          {"GF-link", LineType::third_link, "G", ""},
                                          {"C-drawn", LineType::drawn, "", ""},
                                          {"E-drawn", LineType::drawn, "", ""},
                                          {"C", LineType::first_pin, "B", ""},
                                          {"E", LineType::second_pin, "D", "C"},
                                          {"F", LineType::third_pin, "C", "E"}};
constexpr PointRow kThreePinsOnCrank[] = {{"A", LineType::pivot, "", ""},
                                          {"G", LineType::pivot, "", ""},
                                          {"B", LineType::crank, "A", ""},
                                          {"H", LineType::attached, "A", "B"},
                                          {"GF-link", LineType::third_link, "G", ""},
                                          {"C-drawn", LineType::drawn, "", ""},
                                          {"E-drawn", LineType::drawn, "", ""},
                                          {"C", LineType::first_pin, "B", ""},
                                          {"E", LineType::second_pin, "H", "C"},
                                          {"F", LineType::third_pin, "C", "E"}};
constexpr PointRow kOnCE[] = {{"P", LineType::attached, "C", "E"}};

struct TopologyRow {
  std::string_view name;
  std::array<Rows, 4> parts;  ///< one after the other; the last point is the traced one
};

constexpr TopologyRow kTopologies[] = {
    {kSliderCrankWord, {kSliderCrank, kOnBC}},
    {"four-bar", {kFourBar, kOnBC}},
    {"stephenson-3", {kFourBar, kStephenson, kOnEF}},
    {"watt-1", {kFourBar, kWatt, kOnEF}},
    {"watt-1-hf", {kFourBar, kWatt, kOnHF}},
    {"eight-bar-1", {kFourBar, kStephenson, kToFrame, kOnKJ}},
    {"eight-bar-2", {kFourBar, kWatt, kToFrame, kOnKJ}},
    {"eight-bar-3", {kFourBar, kStephenson, kToSecondLink, kOnKJ}},
    {"eight-bar-4", {kFourBar, kWatt, kToRockerLink, kOnKJ}},
    {"eight-bar-5", {kFourBar, kStephenson, kToCoupler, kOnKJ}},
    {"three-pin-1", {kThreePinsOnFrame, kOnBC}},
    {"three-pin-2", {kThreePinsOnCrank, kOnCE}}};

constexpr TopologyRow kFunctionTopologies[] = {{"stephenson-3", {kFourBar, kStephenson}},
                                               {"watt-2", {kFourBar, kSecondFourBar}},
                                               {kSliderCrankWord, {kSliderCrank}},
                                               {"stephenson-3-slider", {kFourBar, kCouplerSlider}},
                                               {"watt-2-slider", {kFourBar, kRockerSlider}},
                                               {"three-pin-1", {kThreePinsOnFrame}},
                                               {"three-pin-2", {kThreePinsOnCrank}}};

constexpr TopologyRow kLegTopologies[] = {{"klann", {kKlann}}, {"jansen", {kJansen}}};

constexpr TopologyWord kWords[] = {
    {kSliderCrankWord, "slider-crank, the point on its connecting rod"},
    {"stephenson-3", "Stephenson III six-bar"},
    {"watt-1", "Watt I six-bar, the point on the link that the coupler carries"},
    {"watt-1-hf", "Watt I six-bar, the point on the link that the rocker carries"},
    {"six-bar", "whichever of these three comes nearest"},
    {"eight-bar-1", "Stephenson III, and a dyad from its link EF to the frame"},
    {"eight-bar-2", "Watt I, and a dyad from its link EF to the frame"},
    {"eight-bar-3", "Stephenson III, and a dyad between its links EF and GF"},
    {"eight-bar-4", "Watt I, and a dyad between its links EF and HF"},
    {"eight-bar-5", "Stephenson III, and a dyad between its link EF and the coupler"},
    {"eight-bar", "whichever of these five comes nearest"},
    {"three-pin-1",
     "link with three pins on two rockers and a link from the crank, the point on the latter "
     "(Stephenson III, driven in its five-bar loop)"},
    {"three-pin-2",
     "link with three pins on a rocker and two links from the crank, the point on it "
     "(Stephenson I, driven in its five-bar loop)"},
    {"three-pin", "whichever of these two comes nearest"},
    {"any", "whichever comes nearest of the four-bar, all six-bars and all eight-bars"}};

constexpr TopologyWord kFunctionWords[] = {
    {"stephenson-3", "Stephenson III six-bar, the output hung on its coupler"},
    {"watt-2", "Watt II six-bar, a second four-bar driven by the rocker of the first"},
    {"six-bar", "whichever of these two comes nearest"},
    {kSliderCrankWord, "slider-crank, its slider C the output"},
    {"stephenson-3-slider", "four-bar whose coupler drives the slider F, the output"},
    {"watt-2-slider", "four-bar whose rocker drives the slider F, the output"},
    {"six-bar-slider", "whichever of these two comes nearest"},
    {"three-pin-1",
     "link with three pins on two rockers and a link from the crank, the output one of the rockers "
     "(Stephenson III, driven in its five-bar loop)"},
    {"three-pin-2",
     "link with three pins on two links from the crank and the output "
     "(Stephenson I, driven in its five-bar loop)"},
    {"three-pin", "whichever of these two comes nearest"}};

constexpr TopologyWord kLegWords[] = {
    {"klann", "Klann's leg, a Stephenson III six-bar"},
    {"jansen", "Jansen's leg, an eight-bar with two dyads on the crank's pin"}};

bool stands_for(std::string_view word, std::string_view topology) {
  const bool has_three_pins = topology.starts_with("three-pin");
  if (word == "any") return topology != kSliderCrankWord && !has_three_pins;
  if (word == "three-pin") return has_three_pins;
  const bool is_six_bar = topology.starts_with("watt") || topology.starts_with("stephenson");
  if (word == "six-bar") return is_six_bar && !topology.ends_with("-slider");
  if (word == "six-bar-slider") return topology.ends_with("-slider");
  if (word == "eight-bar") return topology.starts_with("eight-bar");
  return word == topology;
}

int line_of(const Topology& topology, std::string_view name) {
  const auto found = std::ranges::find(topology.lines, name, &TopologyLine::name);
  return found == topology.lines.end() ? -1 : static_cast<int>(found - topology.lines.begin());
}

Topology topology_of(const TopologyRow& row) {
  Topology topology;
  topology.name = row.name;
  for (const Rows& part : row.parts) {
    for (const auto& [name, type, first, second] : part) {
      const ChainLine line{type, line_of(topology, first), line_of(topology, second)};
      topology.lines.push_back({.name = std::string(name), .line = line});
    }
  }
  topology.trace = static_cast<int>(topology.lines.size()) - 1;
  return topology;
}

std::vector<Topology> topologies_of(std::string_view word, std::span<const TopologyWord> words,
                                    std::span<const TopologyRow> rows) {
  std::vector<Topology> all;
  if (std::ranges::find(words, word, &TopologyWord::word) == words.end()) return all;
  for (const TopologyRow& row : rows) {
    if (stands_for(word, row.name)) all.push_back(topology_of(row));
  }
  return all;
}

}  // namespace

std::vector<Topology> topologies(std::string_view word) {
  return topologies_of(word, kWords, kTopologies);
}

std::span<const TopologyWord> topology_words() {
  return kWords;
}

std::vector<Topology> function_topologies(std::string_view word) {
  return topologies_of(word, kFunctionWords, kFunctionTopologies);
}

std::span<const TopologyWord> function_topology_words() {
  return kFunctionWords;
}

bool ends_in_slider(const Topology& topology) {
  return topology.lines.back().line.type == LineType::slider;
}

std::vector<Topology> leg_topologies(std::string_view word) {
  auto own = topologies_of(word, kLegWords, kLegTopologies);
  return own.empty() ? topologies(word) : own;
}

std::span<const TopologyWord> leg_topology_words() {
  return kLegWords;
}

}  // namespace cognate::problems
