#include "analysis/batch/dispatch.hpp"

#include <algorithm>

namespace cognate::batch {
namespace {

template <class Real>
Kernels<Real> kernels_of(InstructionSet set) {
  Kernels<Real> kernels{};
  switch (set) {
    case InstructionSet::scalar:
      scalar::get_kernels(kernels);
      break;
#ifdef COGNATE_X86_KERNELS
    case InstructionSet::sse2:
      sse2::get_kernels(kernels);
      break;
    case InstructionSet::avx2:
      avx2::get_kernels(kernels);
      break;
    case InstructionSet::avx512:
      avx512::get_kernels(kernels);
      break;
#else
    default:
      break;
#endif
  }
  return kernels;
}

}  // namespace

template <class Real>
std::optional<Kernels<Real>> find_kernels(std::optional<InstructionSet> set) {
  const auto here = instruction_sets();
  if (!set) return kernels_of<Real>(here.back());
  if (std::find(here.begin(), here.end(), *set) == here.end()) return std::nullopt;
  return kernels_of<Real>(*set);
}

template std::optional<Kernels<double>> find_kernels(std::optional<InstructionSet> set);
template std::optional<Kernels<float>> find_kernels(std::optional<InstructionSet> set);

}  // namespace cognate::batch
