/// @file A chain in point form, over any type of number, that keeps what its view points to.
#pragma once

#include <vector>

#include "synthesis/chain/sweep.hpp"

namespace cognate::test {

template <class T>
class PosedChain {
 public:
  PosedChain(const synthesis::Chain& chain, const synthesis::ChainDesign& design)
      : lines_(placed_lines(chain)),
        parameters(design.parameters.begin(), design.parameters.end()),
        side_(design.side.begin(), design.side.end()) {}

  synthesis::ChainView<T> view() const {
    return {lines_.data(), static_cast<int>(lines_.size()), parameters.data(), side_.data()};
  }
  /// Where all is with the crank in this direction.
  const synthesis::ChainPlace<T>& at(const Vec2<T>& crank) {
    place(view(), crank, place_);
    return place_;
  }
  int last() const { return static_cast<int>(lines_.size()) - 1; }

 private:
  std::vector<synthesis::PlacedLine> lines_;

 public:
  std::vector<T> parameters;

 private:
  std::vector<T> side_;
  synthesis::ChainPlace<T> place_;
};

}  // namespace cognate::test
