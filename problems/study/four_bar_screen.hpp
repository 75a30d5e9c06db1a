/// @file The filters of a study of four-bars that lengths decide, for many designs side by side.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "problems/study/four_bar_designs.hpp"
#include "problems/study/four_bar_quantities.hpp"

namespace cognate::problems {

/// A filter and what it is on.
struct FourBarFilter {
  FourBarQuantity quantity;
  const StudyFilter* limits = nullptr;
};

/// Whether the numbers of a design are of common size, so that a file with them is read and squares
/// of them are far from the ends of what doubles hold.
bool is_common(const FourBar& linkage);

/// Leaves out designs that surely fail: class and rotation by Grashof's criterion, transmission
/// angles and time ratio by the cosines of the bounds. It knows no trigonometry and runs in the
/// machine's lanes. What is within 1e-9 of a bound, or of uncommon size, stays for a closer look.
class FourBarScreen {
 public:
  explicit FourBarScreen(std::span<const FourBarFilter> filters);

  /// Writes 1 for designs that stay, 0 for the others.
  void operator()(const FourBarDesigns& designs, std::span<const double> values,
                  std::size_t variables, std::span<double> stays);

 private:
  struct Cosines {
    double least = -2, greatest = 2;
  };
  struct Varied {
    std::size_t variable;
    double min, max;
  };

  void add(const FourBarFilter& filter);
  void screen_varied(std::span<const double> values, std::size_t variables,
                     std::span<double> stays) const;
  void screen_class(const FourBarDesigns& designs, std::span<double> stays) const;
  void screen_transmission(const FourBarDesigns& designs, std::span<double> stays) const;
  void screen_time_ratio(const FourBarDesigns& designs, std::span<double> stays) const;

  std::vector<Varied> varied_;
  std::array<double, 5> allowed_{1, 1, 1, 1, 1};  ///< of the classes, in their order
  bool by_class_ = false, by_transmission_ = false, by_time_ratio_ = false;
  Cosines least_, greatest_, acute_, advance_;
};

}  // namespace cognate::problems
