/// @file Which chain is designed: its points with their names, and what of its dimensions is given.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "problems/basics/range.hpp"
#include "problems/mechanism/named_mechanism.hpp"
#include "synthesis/chain/chain.hpp"

namespace cognate::problems {

/// A line of a topology. Lengths are in the file's unit, directions of guides in radians.
struct TopologyLine {
  std::string name;  ///< of the point; of a guide that of its slider, with "-slide" behind it
  synthesis::ChainLine line;
  std::array<std::optional<double>, 2> given{};  ///< of its parameters; empty: found
  std::array<Range, 2> bounds{Range{-kUnbounded, kUnbounded}, Range{-kUnbounded, kUnbounded}};
  std::optional<Assembly> assembly{};  ///< of a dyad or a slider; empty: either

  static constexpr double kUnbounded = std::numeric_limits<double>::infinity();
};

/// A chain whose dimensions are found where they are not given.
struct Topology {
  std::string name;  ///< as files write it: "watt-1"; "chain" for one that the file describes
  std::vector<TopologyLine> lines;
  int trace = 0;  ///< the line of the point whose path counts
};

/// A value of `mechanism.type`, and what it means in a few words.
struct TopologyWord {
  std::string_view word;
  std::string_view meaning;
};

/// `mechanism.type` of a chain that the file describes point by point.
inline constexpr std::string_view kChainWord = "chain";

/// `type` of a `[[dyad]]` of such a chain that is a link with three pins.
inline constexpr std::string_view kThreePinWord = "three-pin";

/// `mechanism.type` of the chain of a crank and one slider.
inline constexpr std::string_view kSliderCrankWord = "slider-crank";

/// The topologies that the word `mechanism.type` stands for: one, or several that are tried in
/// turns ("six-bar"). Empty for a word that is no topology.
std::vector<Topology> topologies(std::string_view word);

/// The words that `topologies` knows.
std::span<const TopologyWord> topology_words();

/// The same for functions of the crank's angle: the output is the link from G to F, or the slider
/// whose pin is the last line.
std::vector<Topology> function_topologies(std::string_view word);
std::span<const TopologyWord> function_topology_words();

/// Whether the last line of a topology is a slider.
bool ends_in_slider(const Topology& topology);

/// The same for legs: the path is the foot's. The words of paths are words of legs too.
std::vector<Topology> leg_topologies(std::string_view word);
std::span<const TopologyWord> leg_topology_words();

/// Whether it has a link with three pins, which makes it a mechanism of class III.
bool has_three_pin_link(const Topology& topology);

/// A chain in a line: "crank AB; C(B, D); E on BC; F(E, G); P on EF".
std::string sketch(const Topology& topology);

/// The name of a link by two of its points: "BC", and "B1-C" where one is longer than a letter.
std::string link_name(const std::string& first, const std::string& second);

/// The names of the links of a dyad, which join `first` and `second` to its `joint`.
std::array<std::string, 2> link_names(const std::string& first, const std::string& second,
                                      const std::string& joint);

/// The name of the guide of the slider whose pin is `pin`.
std::string guide_name(const std::string& pin);

/// The names of the lines of a three-pin link that are no points: of the link from `first` to its
/// third pin, and of the place where a pin is drawn.
std::string third_link_name(const std::string& first, const std::string& third);
std::string drawn_name(const std::string& pin);

/// Whether a line of this type is a point of the mechanism.
bool is_point(synthesis::LineType type);

/// The names of the link from `first` to the pin of a slider, and of the slider.
std::array<std::string, 2> slider_link_names(const std::string& first, const std::string& pin);

/// The number of links, the frame among them.
int link_count(const Topology& topology);

/// The names of the links of each topology, without the frame.
std::vector<std::vector<std::string>> links_of(std::span<const Topology> topologies);

/// The lines of `topology` alone.
synthesis::Chain chain_of(const Topology& topology);

/// The mechanism that `design` is, with the names of `topology`.
NamedMechanism named(const Topology& topology, const synthesis::ChainDesign& design);

/// Which of the mechanism's dyads the slider with this pin is; a three-pin link counts there as
/// more than one. Empty where there is no such slider.
std::optional<int> slider_dyad(const NamedMechanism& mechanism, const std::string& pin);

/// The guide of the frame on which the slider with this pin runs; empty where there is none.
std::optional<Guide<double>> guide_of(const NamedMechanism& mechanism, const std::string& pin);

/// The dimensions of a mechanism of this topology.
synthesis::ChainDesign dimensions(const Topology& topology, const NamedMechanism& mechanism);

}  // namespace cognate::problems
