#include "synthesis/lanes/path_screen.hpp"

#include "synthesis/lanes/path_screen_kernel.hpp"

namespace cognate::synthesis {
namespace {

struct Choice {
  ScreenKernel kernel;
  const char* name;
};

#ifdef COGNATE_X86_KERNELS

Choice choose() {
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd")) {
    return {screen_avx512, "avx512"};
  }
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
    return {screen_avx2, "avx2"};
  }
  return {screen_sse2, "sse2"};
}

#else

void screen_scalar(const SeparableTarget& target, const PathCandidateArrays& all) {
  for (unsigned long i = 0; i < all.count; ++i) {
    const Lengths<double> ratios{1, all.coupler[i], all.rocker[i], all.frame[i]};
    const Vec2d phase{all.phase_cos[i], all.phase_sin[i]};
    all.open[i] = separable_fit(target, ratios, phase, 1.0).error;
    all.crossed[i] = separable_fit(target, ratios, phase, -1.0).error;
  }
}

Choice choose() {
  return {screen_scalar, "scalar"};
}

#endif

const Choice& chosen() {
  static const Choice choice = choose();
  return choice;
}

}  // namespace

void screen(const SeparableTarget& target, PathCandidates& candidates) {
  chosen().kernel(target,
                  {candidates.coupler.data(), candidates.rocker.data(), candidates.frame.data(),
                   candidates.phase_cos.data(), candidates.phase_sin.data(), candidates.open.data(),
                   candidates.crossed.data(), candidates.coupler.size()});
}

const char* screen_instruction_set() {
  return chosen().name;
}

}  // namespace cognate::synthesis
