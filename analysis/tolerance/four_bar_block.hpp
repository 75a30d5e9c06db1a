/// @file Samples of a four-bar on the kernel of batches, which prepares each linkage once for all
/// positions.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "analysis/batch/crank_table.hpp"
#include "analysis/batch/instruction_set.hpp"
#include "analysis/tolerance/affine_mechanism.hpp"
#include "analysis/tolerance/response.hpp"
#include "analysis/tolerance/sample_kernel.hpp"

namespace cognate::tolerance {

/// Blocks of one mechanism at fixed stations.
class FourBarBlock {
 public:
  /// Empty where the batches' kernel does not have what is asked for: the mechanism is no four-bar,
  /// a dimension turns its frame, its assembly changes along the motion, or an output is neither
  /// the rocker's angle nor a point of the coupler nor, as the last one, the transmission angle.
  static std::optional<FourBarBlock> of(const AffineMechanism& mechanism,
                                        std::span<const Station> stations,
                                        std::span<const BlockOutput> outputs, InstructionSet set);

  /// Fills the columns of the outputs, which are in one piece: x of each, then y of each.
  void evaluate(const SampleKernels& kernels, const BlockTask& task, std::span<double> values);

 private:
  FourBarBlock(CrankTable<double> cranks, std::span<const BlockOutput> outputs, double side,
               InstructionSet set);

  CrankTable<double> cranks_;
  std::vector<BlockOutput> outputs_;
  std::size_t points_ = 0;  ///< outputs but for a transmission angle
  double side_ = 1;
  InstructionSet set_;
  std::vector<double> dimensions_;  ///< a column of each of those of a FourBarTask
};

}  // namespace cognate::tolerance
