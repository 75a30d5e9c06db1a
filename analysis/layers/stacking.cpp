#include "analysis/layers/stacking.hpp"

#include <bit>
#include <limits>

namespace cognate {
namespace {

using PinSet = std::uint64_t;

/// The best stack of a set of links.
struct Best {
  int layers = std::numeric_limits<int>::max();
  int crossings = 0;
  LinkSet top = 0;  ///< its highest layer

  bool is_reached() const { return layers < std::numeric_limits<int>::max(); }
  bool is_better_than(const Best& other) const {
    return layers != other.layers ? layers < other.layers : crossings < other.crossings;
  }
};

/// Stacks of the links `all` alone.
class Stacker {
 public:
  Stacker(const StackProblem& problem, LinkSet all)
      : problem_(problem), all_(all), best_(std::size_t{all} + 1), fits_(best_.size(), 1) {
    for (LinkSet set = 1; set <= all; ++set) {
      const int lowest = std::countr_zero(set);
      const LinkSet others = set & (set - 1);
      fits_[set] = fits_[others] && !(problem.apart[static_cast<std::size_t>(lowest)] & others);
    }
  }

  bool exhaust() {
    best_[0].layers = 0;
    for (LinkSet below = 0; below < all_; ++below) {
      if ((below & ~all_) == 0 && best_[below].is_reached()) stack_on(below);
    }
    return best_[all_].is_reached();
  }

  Stack stack() const {
    Stack found;
    found.tried = tried_;
    if (!best_[all_].is_reached()) return found;
    found.count = best_[all_].layers;
    found.crossings = best_[all_].crossings;
    found.layers.assign(problem_.apart.size(), 0);
    for (LinkSet set = all_; set != 0; set &= ~best_[set].top) {
      for (std::size_t link = 0; link < found.layers.size(); ++link) {
        if (best_[set].top >> link & 1) found.layers[link] = best_[set].layers;
      }
    }
    return found;
  }

 private:
  /// Every layer on top of `below`.
  void stack_on(LinkSet below) {
    const LinkSet rest = all_ & ~below;
    for (LinkSet layer = rest; layer != 0; layer = (layer - 1) & rest) {
      ++tried_;
      if (!fits_[layer]) continue;
      const int crossings = crossings_of(below, layer);
      if (crossings < 0) continue;
      Best& there = best_[below | layer];
      const Best next{best_[below].layers + 1, best_[below].crossings + crossings, layer};
      if (next.is_better_than(there)) there = next;
    }
  }

  /// How many pins cross `layer` on top of `below` without a link in it; −1 where one cannot.
  int crossings_of(LinkSet below, LinkSet layer) const {
    const LinkSet above = all_ & ~(below | layer);
    PinSet crossing = 0, hit = 0;
    int count = 0;
    for (std::size_t i = 0; i < problem_.pins.size(); ++i) {
      const StackPin& pin = problem_.pins[i];
      const bool comes = pin.on_base || (pin.links & below);
      if (!comes || !(pin.links & above)) continue;
      if (pin.stops_at & layer & ~pin.links) return -1;
      crossing |= PinSet{1} << i;
      hit |= pin.pins_hit;
      if (!(pin.links & layer)) ++count;
    }
    return crossing & hit ? -1 : count;
  }

  const StackProblem& problem_;
  LinkSet all_;
  std::vector<Best> best_;
  std::vector<char> fits_;  ///< whether the links of a set can be in one layer
  std::size_t tried_ = 0;
};

/// Links of `all`, which has no stack, that have none by themselves and have one without any of
/// them.
LinkSet blocked_core(const StackProblem& problem, LinkSet all) {
  for (LinkSet rest = all; rest != 0; rest &= rest - 1) {
    const LinkSet without = all & ~(rest & -rest);
    if (!Stacker(problem, without).exhaust()) all = without;
  }
  return all;
}

}  // namespace

Stack fewest_layers(const StackProblem& problem) {
  const auto all = static_cast<LinkSet>((LinkSet{1} << problem.apart.size()) - 1);
  Stacker stacker(problem, all);
  const bool found = stacker.exhaust();
  Stack stack = stacker.stack();
  if (!found) stack.blocked = blocked_core(problem, all);
  return stack;
}

}  // namespace cognate
