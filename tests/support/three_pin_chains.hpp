/// @file Chains with a three-pin link whose cranks turn fully.
#pragma once

#include <array>
#include <vector>

#include "analysis/numbers/vec2.hpp"
#include "synthesis/chain/sweep.hpp"

namespace cognate::test {

struct PinnedChain {
  synthesis::Chain chain;
  synthesis::ChainDesign design;
  int base;  ///< the first line of the three-pin link
};

/// The parameters of the six lines of a link by where its pins and what holds them stand with the
/// crank at angle 0.
inline std::vector<double> drawn_lines(const std::array<Vec2d, 3>& pins,
                                       const std::array<Vec2d, 3>& holders) {
  const Vec2d way = pins[1] - pins[0];
  const Vec2d third = conj((1 / norm(way)) * way) * (pins[2] - pins[0]);
  return {norm(pins[2] - holders[2]),
          pins[0].x,
          pins[0].y,
          pins[1].x,
          pins[1].y,
          norm(pins[0] - holders[0]),
          norm(pins[1] - holders[1]),
          norm(way),
          third.x,
          third.y};
}

inline std::vector<double> joined(std::vector<double> a, const std::vector<double>& b,
                                  const std::vector<double>& c) {
  a.insert(a.end(), b.begin(), b.end());
  a.insert(a.end(), c.begin(), c.end());
  return a;
}

/// Pins on two rockers and a link from the crank; on a rocker and two links from the crank; on a
/// rocker, a link from the crank and one from the coupler of a four-bar. The last line is a point.
inline std::vector<PinnedChain> three_pin_chains() {
  using synthesis::Chain;
  using synthesis::LineType;
  const std::array<Vec2d, 3> pins{Vec2d{3.33, -1.5}, {2.2, 3.0}, {4.6, -3.0}};
  const Vec2d pivots[] = {{-1.8, 0.2}, {1.9, -4.7}};
  const Chain frame{{{LineType::pivot},
                     {LineType::pivot},
                     {LineType::pivot},
                     {LineType::crank, 0},
                     {LineType::third_link, 2},
                     {LineType::drawn},
                     {LineType::drawn},
                     {LineType::first_pin, 3},
                     {LineType::second_pin, 1, 7},
                     {LineType::third_pin, 7, 8},
                     {LineType::attached, 3, 7}}};
  const auto on_frame =
      joined({0, 0, pivots[0].x, pivots[0].y, pivots[1].x, pivots[1].y, 0.6},
             drawn_lines(pins, {Vec2d{0.6, 0}, pivots[0], pivots[1]}), {0.7, 0.3});
  Chain crank = frame;
  crank.lines[1] = {LineType::pivot};
  crank.lines[2] = {LineType::crank, 0};
  crank.lines[3] = {LineType::attached, 0, 2};
  crank.lines[4] = {LineType::third_link, 1};
  crank.lines[7] = {LineType::first_pin, 2};
  crank.lines[8] = {LineType::second_pin, 3, 7};
  crank.lines[10] = {LineType::attached, 7, 8};
  const auto on_crank =
      joined({0, 0, 1.9, -4.7, 0.6, 0.1, 0.5},
             drawn_lines(pins, {Vec2d{0.6, 0}, {0.1, 0.5}, pivots[1]}), {0.7, 0.3});
  const Chain coupler{{{LineType::pivot},
                       {LineType::pivot},
                       {LineType::pivot},
                       {LineType::crank, 0},
                       {LineType::dyad, 3, 1},
                       {LineType::attached, 3, 4},
                       {LineType::third_link, 2},
                       {LineType::drawn},
                       {LineType::drawn},
                       {LineType::first_pin, 3},
                       {LineType::second_pin, 5, 9},
                       {LineType::third_pin, 9, 10},
                       {LineType::attached, 9, 10}}};
  const double reach = 2.4;
  const Vec2d joint = synthesis::dyad_joint(Vec2d{0.6, 0}, pivots[0], 2.0, reach, 1.0);
  const Vec2d axis = (1 / norm(joint - Vec2d{0.6, 0})) * (joint - Vec2d{0.6, 0});
  const Vec2d carried = Vec2d{0.6, 0} + Vec2d{0.4, 0.5} * axis;
  const auto on_coupler =
      joined({0, 0, pivots[0].x, pivots[0].y, pivots[1].x, pivots[1].y, 0.6, 2.0, reach, 0.4, 0.5},
             drawn_lines(pins, {Vec2d{0.6, 0}, carried, pivots[1]}), {0.7, 0.3});
  const auto open = [](const Chain& chain, const std::vector<double>& parameters) {
    return synthesis::ChainDesign{parameters, std::vector<int>(chain.lines.size(), 1)};
  };
  return {{frame, open(frame, on_frame), 4},
          {crank, open(crank, on_crank), 4},
          {coupler, open(coupler, on_coupler), 6}};
}

}  // namespace cognate::test
