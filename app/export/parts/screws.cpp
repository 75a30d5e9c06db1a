#include "app/export/parts/screws.hpp"

#include <algorithm>
#include <array>

#include "analysis/numbers/constants.hpp"

namespace cognate::app {
namespace {

constexpr std::array kScrews = {Screw{"M3", 3, 0.5, 3.2, 5.5, 3, 4.5, 5.5, 7, 0.5},
                                Screw{"M4", 4, 0.7, 4.3, 7, 4, 6, 7, 9, 0.8},
                                Screw{"M5", 5, 0.8, 5.3, 8.5, 5, 6.8, 8, 10, 1},
                                Screw{"M6", 6, 1, 6.4, 10, 6, 8, 10, 12, 1.6},
                                Screw{"M8", 8, 1.25, 8.4, 13, 8, 9.5, 13, 16, 1.6},
                                Screw{"M10", 10, 1.5, 10.5, 16, 10, 11.9, 16, 20, 2},
                                Screw{"M12", 12, 1.75, 13, 18, 12, 14.9, 18, 24, 2.5},
                                Screw{"M16", 16, 2, 17, 24, 16, 19.1, 24, 30, 3}};

// Of ISO 4762: nominal lengths, and the least and the greatest of each screw of the table.
constexpr std::array<double, 26> kScrewLengths = {5,  6,   8,   10,  12,  16,  20,  25, 30,
                                                  35, 40,  45,  50,  55,  60,  65,  70, 80,
                                                  90, 100, 110, 120, 130, 140, 150, 160};
constexpr std::array<std::array<double, 2>, kScrews.size()> kScrewRanges = {
    {{5, 30}, {6, 40}, {8, 50}, {10, 60}, {12, 80}, {16, 100}, {20, 120}, {25, 160}}};

}  // namespace

Screw Screw::scaled(double factor) const {
  Screw screw = *this;
  for (double* size :
       {&screw.diameter, &screw.pitch, &screw.hole, &screw.head_diameter, &screw.head_height,
        &screw.nut_height, &screw.nut_width, &screw.washer_outside, &screw.washer_thickness}) {
    *size *= factor;
  }
  return screw;
}

std::optional<Screw> screw_called(std::string_view designation) {
  const auto found = std::ranges::find(kScrews, designation, &Screw::designation);
  return found == kScrews.end() ? std::nullopt : std::optional(*found);
}

std::string screw_designations() {
  return "M3, M4, M5, M6, M8, M10, M12 or M16";
}

std::optional<double> screw_length(const Screw& screw, double least) {
  const auto own = std::ranges::find(kScrews, screw.designation, &Screw::designation);
  const double millimetre = screw.diameter / own->diameter;
  const auto [shortest, longest] = kScrewRanges.at(static_cast<std::size_t>(own - kScrews.begin()));
  for (const double length : kScrewLengths) {
    if (length < shortest || length > longest) continue;
    if (length * millimetre >= least * (1 - kEpsilon)) return length * millimetre;
  }
  return std::nullopt;
}

}  // namespace cognate::app
