#include "app/report/kernel/numbers.hpp"

#include <cstddef>

namespace cognate::page {

namespace {
constexpr std::size_t kCount = 65536;
double block[kCount];
}  // namespace

std::span<double> numbers() {
  return block;
}

/// Where the block begins in the memory of the module.
COGNATE_EXPORT(numbers) double* first_number() {
  return block;
}

}  // namespace cognate::page
