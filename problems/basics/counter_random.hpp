/// @file Random numbers that are a function of where they stand, so that any can be had alone.
#pragma once

#include <cstdint>

namespace cognate::problems {

/// The finaliser of SplitMix64 (Steele, Lea, Flood, "Fast splittable pseudorandom number
/// generators", 2014; constants of Stafford's variant 13): a bijection.
constexpr std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31U);
}

inline constexpr std::uint64_t kGoldenStep = 0x9e3779b97f4a7c15U;  ///< 2^64 over the golden ratio

/// Word `index` of SplitMix64 begun with `seed`.
constexpr std::uint64_t split_mix(std::uint64_t seed, std::uint64_t index) {
  return mixed(seed + (index + 1) * kGoldenStep);
}

/// Word `index` of stream `stream` of `seed`. Words of one stream are all different.
constexpr std::uint64_t random_word(std::uint64_t seed, std::uint64_t stream, std::uint64_t index) {
  return mixed(mixed(mixed(seed + kGoldenStep) ^ (stream + kGoldenStep)) ^ (index + kGoldenStep));
}

/// A word as a number in [0, 1), by its upper 53 bits.
constexpr double unit_number(std::uint64_t word) {
  return static_cast<double>(word >> 11U) * 0x1p-53;
}

}  // namespace cognate::problems
