#include "problems/study/random_permutation.hpp"

#include "problems/basics/counter_random.hpp"

namespace cognate::problems {

RandomPermutation::RandomPermutation(std::uint64_t n, std::uint64_t key) : n_(n) {
  while (half_bits_ < 31 && (n - 1) >> (2 * half_bits_) != 0) ++half_bits_;
  for (std::uint64_t round = 0; round < kRounds; ++round) {
    keys_[round] = random_word(key, 0, round);
  }
}

std::uint64_t RandomPermutation::operator()(std::uint64_t i) const {
  std::uint64_t x = step(i);
  while (x >= n_) x = step(x);
  return x;
}

std::uint64_t RandomPermutation::step(std::uint64_t x) const {
  const std::uint64_t mask = (std::uint64_t{1} << half_bits_) - 1;
  std::uint64_t left = x >> half_bits_, right = x & mask;
  for (const std::uint64_t key : keys_) {
    const std::uint64_t next = left ^ (mixed(right ^ key) & mask);
    left = right;
    right = next;
  }
  return left << half_bits_ | right;
}

}  // namespace cognate::problems
