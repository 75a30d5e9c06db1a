/// @file Random numbers.
#pragma once

#include <random>

namespace cognate {

/// A number in [low, high), each as likely.
inline double uniform(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

}  // namespace cognate
