/// @file Points that fill a unit cube, each to be had without those before it.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>

#include "problems/study/study.hpp"

namespace cognate::problems {

/// A bijection of 0 … n − 1 chosen by a key: a Feistel network over the least even number of bits
/// that holds n − 1, walked along its cycle until it comes back into the range (Black, Rogaway,
/// "Ciphers with arbitrary finite domains", 2002): four steps at most in the mean.
class RandomPermutation {
 public:
  RandomPermutation(std::uint64_t n, std::uint64_t key);

  /// Where `i` < n goes.
  std::uint64_t operator()(std::uint64_t i) const;

 private:
  static constexpr int kRounds = 8;

  std::uint64_t step(std::uint64_t x) const;

  std::uint64_t n_;
  unsigned half_bits_ = 1;
  std::array<std::uint64_t, kRounds> keys_{};
};

/// Writes points from number `first` on, point by point, as many as there is room for: coordinates
/// in [0, 1). What a point is depends on its number alone; used by one thread at a time.
using UnitPoints = std::function<void(std::int64_t first, std::span<double> points)>;

/// The points of `sampling` in `dimensions` ≥ 1; `count` of them are requested.
UnitPoints unit_points(Sampling sampling, std::size_t dimensions, std::int64_t count,
                       std::uint64_t seed);

/// Sobol's sequence with the direction numbers of Joe and Kuo (2008), in the order of Gray's code,
/// from the point 0 on. A seed other than 0 adds a random word to each coordinate, digit by digit
/// (a random digital shift): any 2^k points from a multiple of 2^k on stay as even as they were.
UnitPoints sobol_points(std::size_t dimensions, std::uint64_t seed);

/// Halton's sequence in the first primes as bases, from the point 0 on. A seed other than 0
/// permutes the digits of every place at random (Owen, "A randomized Halton algorithm in R", 2017),
/// without which coordinates in neighbouring large bases would run in step.
UnitPoints halton_points(std::size_t dimensions, std::uint64_t seed);

/// A Latin hypercube (McKay, Beckman, Conover, 1979): of `count` equal parts of each axis every one
/// holds one point, at a random place within it.
UnitPoints latin_points(std::size_t dimensions, std::int64_t count, std::uint64_t seed);

/// Independent uniform numbers.
UnitPoints random_points(std::size_t dimensions, std::uint64_t seed);

}  // namespace cognate::problems
