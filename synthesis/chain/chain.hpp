/// @file A chain in point form: a driving crank and dyads, written line by line, each line a point
/// that closes on points before it. It is what `analysis/mechanism` evaluates body by body, without
/// bodies: as short as a search of many thousand designs wants it.
#pragma once

#include <vector>

namespace cognate::synthesis {

/// What a line makes of the points before it, and by which parameters:
///
///     pivot      a point of the frame                                       x, y
///     crank      the pin of the crank that turns about `first`              length
///     dyad       RRR: the joint of two links from `first` and `second`      their lengths
///     attached   a point of the body on which `first` and `second` are,     u, v
///                in its axes: origin `first`, first axis towards `second`
///     guide      a straight guide of the frame; its point is the foot of    direction, offset
///                the pivot `first`, from which the offset counts, to the
///                left of the direction (radians from the x axis)
///     slider     RRP: the pin of a slider on the guide `second`, joined     length
///                by a link to `first`
///     heading    the direction of a body, that of the attached point        angle from the
///                `first`, which is its point                                body's first axis
///
/// A link with three pins (class III, see held_link.hpp) takes six lines, one after the other:
///
///     third_link   the link from the point `first`, which is its point,    length
///                  to the third pin
///     drawn        where the first pin stands with the crank at angle 0:   x, y
///                  no dimension, but says which assembly is meant
///     drawn        where the second pin stands there                       x, y
///     first_pin    held by a link from `first`                             length
///     second_pin   held by a link from `first`; `second` is the first pin  length, distance from
///                                                                          the first pin
///     third_pin    a point of the body on which `first` and `second` are,  u, v
///                  the other two pins, as of an attached one
enum class LineType {
  pivot,
  crank,
  dyad,
  attached,
  guide,
  slider,
  heading,
  third_link,
  drawn,
  first_pin,
  second_pin,
  third_pin
};

/// The places of a three-pin link's lines from the first of them on.
inline constexpr int kDrawnLine = 1, kFirstPin = 3, kSecondPin = 4, kThirdPin = 5;

constexpr int parameter_count(LineType type) {
  switch (type) {
    case LineType::crank:
    case LineType::slider:
    case LineType::heading:
    case LineType::third_link:
    case LineType::first_pin:
      return 1;
    default:
      return 2;
  }
}

/// Whether the parameters of a line are dimensions of the chain.
constexpr bool has_dimensions(LineType type) {
  return type != LineType::drawn;
}

/// What a parameter is: it says how it changes when a chain is moved, turned and enlarged.
enum class ParameterRole { x, y, length, along, across, direction, offset, body_angle };

constexpr ParameterRole parameter_role(LineType type, int index) {
  switch (type) {
    case LineType::pivot:
    case LineType::drawn:
      return index == 0 ? ParameterRole::x : ParameterRole::y;
    case LineType::attached:
    case LineType::third_pin:
      return index == 0 ? ParameterRole::along : ParameterRole::across;
    case LineType::guide:
      return index == 0 ? ParameterRole::direction : ParameterRole::offset;
    case LineType::heading:
      return ParameterRole::body_angle;
    default:
      return ParameterRole::length;
  }
}

/// Whether a line's parameters are lengths of links.
constexpr bool has_lengths(LineType type) {
  return parameter_role(type, 0) == ParameterRole::length;
}

/// Whether a line places one of the pins of a three-pin link, each with a transmission angle.
constexpr bool is_three_pin(LineType type) {
  return type == LineType::first_pin || type == LineType::second_pin || type == LineType::third_pin;
}

/// Whether a line closes on points that move by themselves, so that it can be assembled in two ways
/// and has a transmission angle.
constexpr bool is_dyad(LineType type) {
  return type == LineType::dyad || type == LineType::slider;
}

struct ChainLine {
  LineType type = LineType::pivot;
  int first = -1, second = -1;  ///< lines before this one, where its type has them
};

/// The longest chain that is swept, 24 points and a heading, and the most parameters it may have.
inline constexpr int kMostLines = 25;
inline constexpr int kMostChainParameters = 2 * kMostLines;

/// One crank; lines only name lines before them. A body that carries attached points is known by
/// two of its points. Chains with three-pin links turn fully.
struct Chain {
  std::vector<ChainLine> lines;
};

/// How many parameters a chain has; those of a line stand together, in the order of the lines.
inline int parameter_count(const Chain& chain) {
  int count = 0;
  for (const ChainLine& line : chain.lines) count += parameter_count(line.type);
  return count;
}

/// A line with the place of its parameters.
struct PlacedLine {
  ChainLine line;
  int parameter = 0;
};

/// The lines of `chain` with the places of their parameters.
inline std::vector<PlacedLine> placed_lines(const Chain& chain) {
  std::vector<PlacedLine> placed;
  int next = 0;
  for (const ChainLine& line : chain.lines) {
    placed.push_back({line, next});
    next += parameter_count(line.type);
  }
  return placed;
}

/// The dimensions of a chain.
struct ChainDesign {
  std::vector<double> parameters;  ///< line by line
  std::vector<int> side;           ///< of each line: a dyad's joint lies to the left (1) or to the
                                   ///< right (−1) of the way from `first` to `second`, a slider
                                   ///< ahead of `first` (1) or behind (−1); else 0
};

}  // namespace cognate::synthesis
