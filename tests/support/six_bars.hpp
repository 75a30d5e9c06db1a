/// @file Six-bars with published figures: the cranks of length 1 about (0, 0), D on the x axis; the
/// path of P on EF, the least transmission angle of each joint over the turn.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "synthesis/chain/chain.hpp"

namespace cognate::test {

struct SixBar {
  std::string_view name;
  synthesis::Chain chain;
  synthesis::ChainDesign design;
  int first_joint, second_joint;       ///< their lines
  std::array<double, 2> transmission;  ///< least of each, degrees
  std::array<double, 4> box;           ///< of the path: x from, to, y from, to
  Vec2d start;                         ///< P at the angle 0 of the crank
};

inline constexpr int kTracedLine = 7;

/// Lines A, D, B, C, E, G or H, F, P.
inline std::array<SixBar, 4> six_bars() {
  using synthesis::LineType;
  const synthesis::Chain stephenson{{{LineType::pivot},
                                     {LineType::pivot},
                                     {LineType::crank, 0},
                                     {LineType::dyad, 2, 1},
                                     {LineType::attached, 2, 3},
                                     {LineType::pivot},
                                     {LineType::dyad, 4, 5},
                                     {LineType::attached, 4, 6}}};
  synthesis::Chain watt = stephenson;
  watt.lines[5] = {LineType::attached, 1, 3};
  return {
      {{"Stephenson III a",
        stephenson,
        {{0, 0, 4, 0, 1, 4, 2, 1.5, 3, 0, 0.5, 3, 1.5, -1, -2.5}, {0, 0, 0, -1, 0, 0, -1, 0}},
        3,
        6,
        {46.567, 36.619},
        {1.582795, 4.728419, 3.904168, 5.064650},
        {4.672811290, 4.433700305}},
       {"Stephenson III b",
        stephenson,
        {{0, 0, 3.5, 0, 1, 4, 4, 3, 0, -1.5, 4.5, 3.5, 3.5, 3.5, -3}, {0, 0, 0, 1, 0, 0, 1, 0}},
        3,
        6,
        {36.420, 50.337},
        {-3.695795, -2.143496, 3.427059, 4.279017},
        {-2.612305864, 3.590878503}},
       {"Watt I a",
        watt,
        {{0, 0, 3.5, 0, 1, 3, 3.5, -2, -0.5, 0, 0.5, 3.5, 2.5, 1.5, -3}, {0, 0, 0, 1, 0, 0, -1, 0}},
        3,
        6,
        {44.415, 49.602},
        {-1.414650, 2.955716, -5.990570, -4.143728},
        {2.407932077, -5.143872267}},
       {"Watt I b",
        watt,
        {{0, 0, 3.5, 0, 1, 3.5, 3.5, 0.5, -2.5, 4, 1, 1.5, 4.5, -2, -2}, {0, 0, 0, -1, 0, 0, 1, 0}},
        3,
        6,
        {41.850, 80.215},
        {-3.227313, -0.651753, -5.939845, -2.616858},
        {-1.905244440, -4.087419589}}}};
}

/// Chains of the same lines but for a slider in place of one of their dyads, without figures: a
/// slider-crank with a dyad on its connecting rod, and a four-bar whose coupler drives a slider.
/// They close over the whole turn.
inline std::vector<SixBar> chains_with_sliders() {
  using synthesis::LineType;
  const synthesis::Chain rod{{{LineType::pivot},
                              {LineType::guide, 0},
                              {LineType::crank, 0},
                              {LineType::slider, 2, 1},
                              {LineType::attached, 2, 3},
                              {LineType::pivot},
                              {LineType::dyad, 4, 5},
                              {LineType::attached, 4, 6}}};
  const synthesis::Chain press{{{LineType::pivot},
                                {LineType::pivot},
                                {LineType::crank, 0},
                                {LineType::dyad, 2, 1},
                                {LineType::attached, 2, 3},
                                {LineType::guide, 1},
                                {LineType::slider, 4, 5},
                                {LineType::attached, 4, 6}}};
  std::vector<SixBar> all;
  for (const int side : {1, -1}) {
    all.push_back({"slider-crank and dyad",
                   rod,
                   {{0.2, -0.1, 0.4, 0.3, 1, 3.5, 2, 0.8, 1, 4.5, 4, 3.5, 1.5, -1},
                    {0, 0, 0, side, 0, 0, side, 0}},
                   3,
                   6});
    all.push_back(
        {"four-bar and slider",
         press,
         {{0, 0, 3.5, 0, 1, 4, 4, 3, 0.5, -0.8, 1.2, 5, 1.5, -2}, {0, 0, 0, side, 0, 0, -side, 0}},
         3,
         6});
  }
  return all;
}

/// All of these.
inline std::vector<SixBar> six_bars_and_sliders() {
  auto all = chains_with_sliders();
  for (const SixBar& six_bar : six_bars()) all.push_back(six_bar);
  return all;
}

}  // namespace cognate::test
