/// @file A chain in point form: a driving crank and dyads, written line by line, each line a point
/// that closes on points before it. It is what `analysis/mechanism` evaluates body by body, without
/// bodies: as short as a search of many thousand designs wants it.
#pragma once

#include <span>
#include <vector>

namespace cognate::synthesis {

/// What a line makes of the points before it, and by which parameters:
///
///     pivot      a point of the frame                                       x, y
///     crank      the pin of the crank that turns about `first`              length
///     dyad       RRR: the joint of two links from `first` and `second`      their lengths
///     attached   a point of the body on which `first` and `second` are,     u, v
///                in its axes: origin `first`, first axis towards `second`
enum class LineType { pivot, crank, dyad, attached };

constexpr int parameter_count(LineType type) {
  return type == LineType::crank ? 1 : 2;
}

struct ChainLine {
  LineType type = LineType::pivot;
  int first = -1, second = -1;  ///< lines before this one, where its type has them
};

/// One crank; lines only name lines before them. A body that carries attached points is known by
/// two of its points.
struct Chain {
  std::vector<ChainLine> lines;
};

/// How many parameters a chain has; those of a line stand together, in the order of the lines.
inline int parameter_count(std::span<const ChainLine> lines) {
  int count = 0;
  for (const ChainLine& line : lines) count += parameter_count(line.type);
  return count;
}

/// The dimensions of a chain.
struct ChainDesign {
  std::vector<double> parameters;  ///< line by line
  std::vector<int> side;           ///< of each line: a dyad's joint lies to the left (1) or to the
                                   ///< right (−1) of the way from `first` to `second`; else 0
};

}  // namespace cognate::synthesis
