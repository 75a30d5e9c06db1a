#include "app/export/parts/bearings.hpp"

#include <algorithm>
#include <array>

namespace cognate::app {
namespace {

// Series 618 and 619 (dimension series 18 and 19), 60 (10) and 62 (02) of ISO 15, bores to 30 mm.
constexpr std::array kBearings = {
    Bearing{"618/1", 1, 3, 1},       Bearing{"618/1.5", 1.5, 4, 1.2}, Bearing{"618/2", 2, 5, 1.5},
    Bearing{"618/2.5", 2.5, 6, 1.8}, Bearing{"618/3", 3, 7, 2},       Bearing{"618/4", 4, 9, 2.5},
    Bearing{"618/5", 5, 11, 3},      Bearing{"618/6", 6, 13, 3.5},    Bearing{"618/7", 7, 14, 3.5},
    Bearing{"618/8", 8, 16, 4},      Bearing{"618/9", 9, 17, 4},      Bearing{"61800", 10, 19, 5},
    Bearing{"61801", 12, 21, 5},     Bearing{"61802", 15, 24, 5},     Bearing{"61803", 17, 26, 5},
    Bearing{"61804", 20, 32, 7},     Bearing{"61805", 25, 37, 7},     Bearing{"61806", 30, 42, 7},
    Bearing{"619/2", 2, 6, 2.3},     Bearing{"619/2.5", 2.5, 7, 2.5}, Bearing{"619/3", 3, 8, 3},
    Bearing{"619/4", 4, 11, 4},      Bearing{"619/5", 5, 13, 4},      Bearing{"619/6", 6, 15, 5},
    Bearing{"619/7", 7, 17, 5},      Bearing{"619/8", 8, 19, 6},      Bearing{"619/9", 9, 20, 6},
    Bearing{"61900", 10, 22, 6},     Bearing{"61901", 12, 24, 6},     Bearing{"61902", 15, 28, 7},
    Bearing{"61903", 17, 30, 7},     Bearing{"61904", 20, 37, 9},     Bearing{"61905", 25, 42, 9},
    Bearing{"61906", 30, 47, 9},     Bearing{"603", 3, 9, 3},         Bearing{"604", 4, 12, 4},
    Bearing{"605", 5, 14, 5},        Bearing{"606", 6, 17, 6},        Bearing{"607", 7, 19, 6},
    Bearing{"608", 8, 22, 7},        Bearing{"609", 9, 24, 7},        Bearing{"6000", 10, 26, 8},
    Bearing{"6001", 12, 28, 8},      Bearing{"6002", 15, 32, 9},      Bearing{"6003", 17, 35, 10},
    Bearing{"6004", 20, 42, 12},     Bearing{"6005", 25, 47, 12},     Bearing{"6006", 30, 55, 13},
    Bearing{"623", 3, 10, 4},        Bearing{"624", 4, 13, 5},        Bearing{"625", 5, 16, 5},
    Bearing{"626", 6, 19, 6},        Bearing{"627", 7, 22, 7},        Bearing{"628", 8, 24, 8},
    Bearing{"629", 9, 26, 8},        Bearing{"6200", 10, 30, 9},      Bearing{"6201", 12, 32, 10},
    Bearing{"6202", 15, 35, 11},     Bearing{"6203", 17, 40, 12},     Bearing{"6204", 20, 47, 14},
    Bearing{"6205", 25, 52, 15},     Bearing{"6206", 30, 62, 16}};

}  // namespace

std::optional<Bearing> bearing_called(std::string_view designation) {
  const auto found = std::ranges::find(kBearings, designation, &Bearing::designation);
  return found == kBearings.end() ? std::nullopt : std::optional(*found);
}

std::vector<Bearing> slimmer_bearings(const Bearing& bearing) {
  std::vector<Bearing> slimmer;
  for (const Bearing& other : kBearings) {
    if (other.bore == bearing.bore && other.outside < bearing.outside) slimmer.push_back(other);
  }
  std::ranges::sort(slimmer, std::greater{}, &Bearing::outside);
  return slimmer;
}

std::string bearing_designations() {
  return "a designation of series 618, 619, 60 or 62 with a bore of at most 30 mm, such as 618/3, "
         "619/5, 608 or 6201";
}

}  // namespace cognate::app
