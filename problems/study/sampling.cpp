#include "problems/study/sampling.hpp"

#include <vector>

#include "problems/basics/counter_random.hpp"

namespace cognate::problems {
namespace {

// Calls `coordinate(number of the point, dimension)` for each place in `points`.
template <class Coordinate>
void fill(std::int64_t first, std::size_t dimensions, std::span<double> points,
          const Coordinate& coordinate) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] = coordinate(static_cast<std::uint64_t>(first) + i / dimensions, i % dimensions);
  }
}

}  // namespace

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

UnitPoints unit_points(Sampling sampling, std::size_t dimensions, std::int64_t count,
                       std::uint64_t seed) {
  switch (sampling) {
    case Sampling::sobol:
      return sobol_points(dimensions, seed);
    case Sampling::halton:
      return halton_points(dimensions, seed);
    case Sampling::latin:
      return latin_points(dimensions, count, seed);
    case Sampling::random:
      break;
  }
  return random_points(dimensions, seed);
}

UnitPoints latin_points(std::size_t dimensions, std::int64_t count, std::uint64_t seed) {
  const auto parts = static_cast<std::uint64_t>(count);
  std::vector<RandomPermutation> order;
  for (std::size_t d = 0; d < dimensions; ++d) order.emplace_back(parts, random_word(seed, d, 0));
  return [=, order = std::move(order)](std::int64_t first, std::span<double> points) {
    fill(first, dimensions, points, [&](std::uint64_t point, std::size_t d) {
      // 20 bits within the part, in the middle of their steps, so that no rounding leaves it.
      const std::uint64_t word = random_word(seed, dimensions + d, point);
      const double within = (static_cast<double>(word >> 44U) + 0.5) * 0x1p-20;
      return (static_cast<double>(order[d](point)) + within) / static_cast<double>(parts);
    });
  };
}

UnitPoints random_points(std::size_t dimensions, std::uint64_t seed) {
  return [=](std::int64_t first, std::span<double> points) {
    fill(first, dimensions, points, [&](std::uint64_t point, std::size_t d) {
      return unit_number(random_word(seed, d, point));
    });
  };
}

}  // namespace cognate::problems
