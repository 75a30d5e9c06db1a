/// @file A random permutation of any length that needs no memory.
#pragma once

#include <array>
#include <cstdint>

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

}  // namespace cognate::problems
