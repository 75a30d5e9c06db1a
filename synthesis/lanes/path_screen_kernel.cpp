// Compiled once for each instruction set: COGNATE_ARCH names xsimd's architecture and
// COGNATE_KERNEL the function.
#include "synthesis/lanes/path_screen_kernel.hpp"

#include <xsimd/xsimd.hpp>

#include "synthesis/lanes/separable_path.hpp"

namespace cognate::synthesis {

void COGNATE_KERNEL(const SeparableTarget& target, const PathCandidateArrays& candidates) {
  using Pack = xsimd::batch<double, COGNATE_ARCH>;
  for (unsigned long i = 0; i < candidates.count; i += Pack::size) {
    const Lengths<Pack> ratios{Pack(1.0), Pack::load_unaligned(candidates.coupler + i),
                               Pack::load_unaligned(candidates.rocker + i),
                               Pack::load_unaligned(candidates.frame + i)};
    const Vec2<Pack> phase{Pack::load_unaligned(candidates.phase_cos + i),
                           Pack::load_unaligned(candidates.phase_sin + i)};
    separable_fit(target, ratios, phase, Pack(1.0)).error.store_unaligned(candidates.open + i);
    separable_fit(target, ratios, phase, Pack(-1.0)).error.store_unaligned(candidates.crossed + i);
  }
}

}  // namespace cognate::synthesis
