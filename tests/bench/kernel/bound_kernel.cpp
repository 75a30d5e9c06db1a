// Compiled once for each instruction set, as analysis/batch/kernel.cpp is.
#include "analysis/batch/lanes.hpp"
#include "tests/bench/kernel/references.hpp"

namespace cognate::bench::COGNATE_ISA {
namespace {

template <class Real>
void bound(const void* a, const void* b, void* out, std::size_t count) {
  using T = batch::COGNATE_ISA::Lanes<Real>;
  const Real* const roots = static_cast<const Real*>(a);
  const Real* const divisors = static_cast<const Real*>(b);
  Real* const results = static_cast<Real*>(out);
  for (std::size_t i = 0; i < count; i += T::kSize) {
    (sqrt(T::load(roots + i)) + T(1) / T::load(divisors + i)).store(results + i);
  }
}

}  // namespace

void bound_double(const void* a, const void* b, void* out, std::size_t count) {
  bound<double>(a, b, out, count);
}

void bound_float(const void* a, const void* b, void* out, std::size_t count) {
  bound<float>(a, b, out, count);
}

}  // namespace cognate::bench::COGNATE_ISA
