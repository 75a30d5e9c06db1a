/// @file Many mechanisms whose dimensions are drawn at random.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "analysis/batch/instruction_set.hpp"
#include "analysis/tolerance/affine_mechanism.hpp"
#include "analysis/tolerance/response.hpp"

namespace cognate {

/// What is judged of each sample at each station. The error of a scalar is `offset` + its deviation
/// from `reference`, its nominal value; of a point its distance from `reference`, the target (the
/// nominal place, say).
struct JudgedResponse {
  Response response;
  std::vector<Vec2d> reference;  ///< one for each station
  std::vector<double> offset;    ///< likewise; of points 0
  /// Of a point of which only the part of its distance along these unit vectors counts, which makes
  /// it a scalar; else empty.
  std::vector<Vec2d> normal;
};

/// Over the assembled samples, of the deviation of a scalar or of a point's distance. Not numbers
/// of no sample, and the standard deviation of one.
struct StationStatistics {
  double mean = 0;
  double standard_deviation = 0;
};

struct ResponseStatistics {
  std::vector<StationStatistics> stations;
  std::vector<double> extremes;  ///< of each assembled sample: its greatest |error| over stations
};

struct SampleStatistics {
  std::size_t samples = 0;    ///< those drawn: fewer than requested if it was stopped
  std::size_t assembled = 0;  ///< of these those that can be assembled at every station
  std::vector<ResponseStatistics> responses;
};

/// How samples are drawn and computed.
struct SamplingOptions {
  std::size_t samples = 0;
  /// Fills changes[d·count + i], those of dimension d in sample first + i. Called from any thread,
  /// with the same arguments for any number of them.
  std::function<void(std::size_t first, std::size_t count, std::span<double> changes)> draw;
  int threads = 1;                                  ///< 0: as many as the machine has
  std::optional<InstructionSet> instruction_set{};  ///< the widest there is, if empty
  std::function<bool()> stop{};                     ///< asked now and then
};

/// The same bits for any number of threads.
SampleStatistics sample(const AffineMechanism& mechanism, std::span<const JudgedResponse> judged,
                        std::span<const Station> stations, const SamplingOptions& options);

}  // namespace cognate
