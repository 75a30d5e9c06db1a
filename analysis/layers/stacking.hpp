/// @file The fewest layers for links and pins that may not share all of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cognate {

/// A set of links (or pins), bit i for number i.
using LinkSet = std::uint32_t;

/// How many links can be stacked.
inline constexpr int kMostStackedLinks = 14;

/// A pin of a stack.
struct StackPin {
  LinkSet links = 0;         ///< that it joins
  bool on_base = false;      ///< whether it rises from below all layers
  LinkSet stops_at = 0;      ///< links whose layer it cannot cross
  std::uint64_t pins_hit{};  ///< pins with which it cannot cross a layer
};

/// Links and pins, at most 64.
struct StackProblem {
  std::vector<LinkSet> apart;  ///< of each link those that cannot be in one layer with it
  std::vector<StackPin> pins;
};

struct Stack {
  std::vector<int> layers;  ///< of each link, from 1 above the base; empty where there is no stack
  int count = 0;
  int crossings = 0;      ///< layers that pins cross without holding a link there
  std::size_t tried = 0;  ///< layers tried on top of sets of links
  LinkSet blocked = 0;    ///< where there is none: links that have none by themselves, and have one
                          ///< without any of them
};

/// The stack of fewest layers, of these the one whose pins cross fewest.
///
/// Which links a layer can take depends only on the set of links below it, not on how that is
/// layered: a pin crosses it if it comes from below and goes on above. So all stacks are exhausted
/// by going once through all sets of links, and from each through all layers on top: 3ⁿ steps.
Stack fewest_layers(const StackProblem& problem);

}  // namespace cognate
