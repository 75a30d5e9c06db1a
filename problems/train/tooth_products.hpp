/// @file Products of numbers of teeth: the ratio of a compound train is a quotient of two of them.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace cognate::problems {

/// A relative error of a ratio up to this is the rounding of an exact one.
inline constexpr double kExactRatio = 4e-16;

/// By how much driven/driver differs from `wanted`, relative to that; 0 where only by rounding. Of
/// the lowest terms, so that all pairs of numbers with one ratio have the same error to the bit.
double ratio_error(std::uint64_t driven, std::uint64_t driver, double wanted);

/// A product of some numbers of teeth, and the least sum of numbers that have it.
struct ToothProduct {
  std::uint64_t product = 1;
  int sum = 0;
};

/// Every product of `count` numbers from `bounds`, once each, in ascending order.
std::vector<ToothProduct> tooth_products(const std::array<int, 2>& bounds, int count);

/// The numbers of `product`, ascending.
std::vector<int> teeth_of(const ToothProduct& product, const std::array<int, 2>& bounds, int count);

/// A quotient of two products.
struct ToothQuotient {
  ToothProduct driven, driver;
  int pairs = 1;
  double error = 0;  ///< relative to the ratio sought

  int size() const { return driven.sum + driver.sum; }
};

/// Which quotients are sought: the best `count` of those within `tolerance` of `ratio`, by error
/// and then by size, or the other way round.
struct QuotientSearch {
  double ratio = 1;
  double tolerance = 0;
  bool by_size = false;
  std::size_t count = 1;
  std::function<bool()> is_over;  ///< asked now and then

  bool is_better(const ToothQuotient& a, const ToothQuotient& b) const;
};

/// Adds the best quotients of `products` to `best`, which stays sorted and no longer than
/// `search.count`. For each driver the driven products near ratio times it are found by bisection
/// and walked outwards, for size by a tree of least sums, so that the cost is that of the products,
/// not of their pairs. No quotient is missed.
void add_quotients(const std::vector<ToothProduct>& products, int pairs,
                   const QuotientSearch& search, std::vector<ToothQuotient>& best);

}  // namespace cognate::problems
