#include "problems/tolerance/grades.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace cognate::problems {
namespace {

constexpr std::size_t kSizes = 21, kGrades = 18;

/// "Up to and including", mm.
constexpr std::array<double, kSizes> kSizesUpTo = {3,   6,    10,   18,   30,   50,   80,
                                                   120, 180,  250,  315,  400,  500,  630,
                                                   800, 1000, 1250, 1600, 2000, 2500, 3150};

// clang-format off
/// Widths in micrometres, a row for each grade.
constexpr double kWidths[kGrades][kSizes] = {
    {0.8, 1, 1, 1.2, 1.5, 1.5, 2, 2.5, 3.5, 4.5, 6, 7, 8, 9, 10, 11, 13, 15, 18, 22, 26},
    {1.2, 1.5, 1.5, 2, 2.5, 2.5, 3, 4, 5, 7, 8, 9, 10, 11, 13, 15, 18, 21, 25, 30, 36},
    {2, 2.5, 2.5, 3, 4, 4, 5, 6, 8, 10, 12, 13, 15, 16, 18, 21, 24, 29, 35, 41, 50},
    {3, 4, 4, 5, 6, 7, 8, 10, 12, 14, 16, 18, 20, 22, 25, 28, 33, 39, 46, 55, 68},
    {4, 5, 6, 8, 9, 11, 13, 15, 18, 20, 23, 25, 27, 32, 36, 40, 47, 55, 65, 78, 96},
    {6, 8, 9, 11, 13, 16, 19, 22, 25, 29, 32, 36, 40, 44, 50, 56, 66, 78, 92, 110, 135},
    {10, 12, 15, 18, 21, 25, 30, 35, 40, 46, 52, 57, 63, 70, 80, 90, 105, 125, 150, 175, 210},
    {14, 18, 22, 27, 33, 39, 46, 54, 63, 72, 81, 89, 97, 110, 125, 140, 165, 195, 230, 280, 330},
    {25, 30, 36, 43, 52, 62, 74, 87, 100, 115, 130, 140, 155, 175, 200, 230, 260, 310, 370, 440,
     540},
    {40, 48, 58, 70, 84, 100, 120, 140, 160, 185, 210, 230, 250, 280, 320, 360, 420, 500, 600, 700,
     860},
    {60, 75, 90, 110, 130, 160, 190, 220, 250, 290, 320, 360, 400, 440, 500, 560, 660, 780, 920,
     1100, 1350},
    {100, 120, 150, 180, 210, 250, 300, 350, 400, 460, 520, 570, 630, 700, 800, 900, 1050, 1250,
     1500, 1750, 2100},
    {140, 180, 220, 270, 330, 390, 460, 540, 630, 720, 810, 890, 970, 1100, 1250, 1400, 1650, 1950,
     2300, 2800, 3300},
    {250, 300, 360, 430, 520, 620, 740, 870, 1000, 1150, 1300, 1400, 1550, 1750, 2000, 2300, 2600,
     3100, 3700, 4400, 5400},
    {400, 480, 580, 700, 840, 1000, 1200, 1400, 1600, 1850, 2100, 2300, 2500, 2800, 3200, 3600,
     4200, 5000, 6000, 7000, 8600},
    {600, 750, 900, 1100, 1300, 1600, 1900, 2200, 2500, 2900, 3200, 3600, 4000, 4400, 5000, 5600,
     6600, 7800, 9200, 11000, 13500},
    {1000, 1200, 1500, 1800, 2100, 2500, 3000, 3500, 4000, 4600, 5200, 5700, 6300, 7000, 8000,
     9000, 10500, 12500, 15000, 17500, 21000},
    {1400, 1800, 2200, 2700, 3300, 3900, 4600, 5400, 6300, 7200, 8100, 8900, 9700, 11000, 12500,
     14000, 16500, 19500, 23000, 28000, 33000}};

constexpr double kNone = 0;  ///< the standard has no value

constexpr std::array<double, 8> kGeneralUpTo = {3, 6, 30, 120, 400, 1000, 2000, 4000};
/// Deviations in mm; a row for each class.
constexpr double kGeneral[4][8] = {{0.05, 0.05, 0.1, 0.15, 0.2, 0.3, 0.5, kNone},
                                   {0.1, 0.1, 0.2, 0.3, 0.5, 0.8, 1.2, 2},
                                   {0.2, 0.3, 0.5, 0.8, 1.2, 2, 3, 4},
                                   {kNone, 0.5, 1, 1.5, 2.5, 4, 6, 8}};
// clang-format on

constexpr Named<ToleranceGrade> kNames[] = {
    {"IT1", ToleranceGrade::it1},   {"IT2", ToleranceGrade::it2},
    {"IT3", ToleranceGrade::it3},   {"IT4", ToleranceGrade::it4},
    {"IT5", ToleranceGrade::it5},   {"IT6", ToleranceGrade::it6},
    {"IT7", ToleranceGrade::it7},   {"IT8", ToleranceGrade::it8},
    {"IT9", ToleranceGrade::it9},   {"IT10", ToleranceGrade::it10},
    {"IT11", ToleranceGrade::it11}, {"IT12", ToleranceGrade::it12},
    {"IT13", ToleranceGrade::it13}, {"IT14", ToleranceGrade::it14},
    {"IT15", ToleranceGrade::it15}, {"IT16", ToleranceGrade::it16},
    {"IT17", ToleranceGrade::it17}, {"IT18", ToleranceGrade::it18},
    {"f", ToleranceGrade::fine},    {"m", ToleranceGrade::medium},
    {"c", ToleranceGrade::coarse},  {"v", ToleranceGrade::very_coarse}};

template <std::size_t Size>
std::optional<std::size_t> column_of(const std::array<double, Size>& up_to, double nominal) {
  const auto found = std::ranges::lower_bound(up_to, nominal);
  if (found == up_to.end()) return std::nullopt;
  return static_cast<std::size_t>(found - up_to.begin());
}

}  // namespace

std::optional<double> deviation_mm(ToleranceGrade grade, double nominal) {
  if (!(nominal > 0)) return std::nullopt;
  const auto index = static_cast<std::size_t>(grade);
  if (grade < ToleranceGrade::fine) {
    const auto column = column_of(kSizesUpTo, nominal);
    const bool coarse_of_small = grade >= ToleranceGrade::it14 && nominal <= 1;
    if (!column || coarse_of_small) return std::nullopt;
    return kWidths[index][*column] / 2000;
  }
  constexpr double kLeast = 0.5;
  const auto column = column_of(kGeneralUpTo, nominal);
  if (!column || nominal < kLeast) return std::nullopt;
  const double deviation =
      kGeneral[index - static_cast<std::size_t>(ToleranceGrade::fine)][*column];
  return deviation > kNone ? std::optional(deviation) : std::nullopt;
}

std::string_view sizes_of(ToleranceGrade grade) {
  if (grade < ToleranceGrade::it14) return "up to 3150 mm";
  switch (grade) {
    case ToleranceGrade::fine:
      return "from 0.5 to 2000 mm";
    case ToleranceGrade::medium:
    case ToleranceGrade::coarse:
      return "from 0.5 to 4000 mm";
    case ToleranceGrade::very_coarse:
      return "above 3 to 4000 mm";
    default:
      return "above 1 to 3150 mm";
  }
}

template <>
std::span<const Named<ToleranceGrade>> names<ToleranceGrade>() {
  return kNames;
}

}  // namespace cognate::problems
