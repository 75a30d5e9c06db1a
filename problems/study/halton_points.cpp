#include <algorithm>
#include <boost/math/special_functions/prime.hpp>
#include <numeric>
#include <utility>
#include <vector>

#include "problems/basics/counter_random.hpp"
#include "problems/study/sampling.hpp"

namespace cognate::problems {
namespace {

constexpr double kBelowOne = 1 - 0x1p-53;

// The radical inverse in one base, each digit replaced by that of its place's permutation. So many
// places that what follows them is less than the last bit of a double.
class ScrambledInverse {
 public:
  ScrambledInverse(std::uint64_t base, std::uint64_t seed, std::uint64_t dimension) : base_(base) {
    for (double weight = 1; weight > 0x1p-53; weight /= static_cast<double>(base)) {
      std::vector<std::uint16_t>& digits = places_.emplace_back(base);
      std::iota(digits.begin(), digits.end(), std::uint16_t{0});
      if (seed != 0) shuffle(digits, random_word(seed, dimension, places_.size()));
    }
  }

  double operator()(std::uint64_t index) const {
    double value = 0, weight = 1;
    for (const auto& digits : places_) {
      weight /= static_cast<double>(base_);
      value += weight * digits[index % base_];
      index /= base_;
    }
    return std::min(value, kBelowOne);
  }

 private:
  static void shuffle(std::vector<std::uint16_t>& digits, std::uint64_t key) {
    for (std::size_t left = digits.size(); left > 1; --left) {
      std::swap(digits[left - 1], digits[random_word(key, 0, left) % left]);
    }
  }

  std::uint64_t base_;
  std::vector<std::vector<std::uint16_t>> places_;
};

}  // namespace

UnitPoints halton_points(std::size_t dimensions, std::uint64_t seed) {
  std::vector<ScrambledInverse> inverses;
  for (unsigned d = 0; d < dimensions; ++d) inverses.emplace_back(boost::math::prime(d), seed, d);
  return [inverses = std::move(inverses)](std::int64_t first, std::span<double> points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto point = static_cast<std::uint64_t>(first) + i / inverses.size();
      points[i] = inverses[i % inverses.size()](point);
    }
  };
}

}  // namespace cognate::problems
