/// @file Paths of a homotopy, followed by many lanes and threads.
#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "analysis/batch/instruction_set.hpp"
#include "synthesis/exact/nine_point/track_kernel.hpp"

namespace cognate::synthesis::nine_point {

/// Ends a computation from outside; shared by its threads.
class StopToken {
 public:
  explicit StopToken(std::function<bool()> ask) : ask_(std::move(ask)) {}
  /// Asks, unless another thread is asking; once the answer was true it stays so.
  bool stopped();

 private:
  std::function<bool()> ask_;
  std::mutex asking_;
  std::atomic<bool> stopped_{false};
};

/// With what paths are followed.
struct TrackingOptions {
  int threads = 0;
  std::optional<InstructionSet> set;
  bool extended = false;  ///< double-double numbers instead of an instruction set
  TrackSettings settings;
  StopToken* stop = nullptr;
  std::function<void(int)> done;  ///< receives the number of paths handed out; from several threads
};

/// Paths to follow: `starts` holds unknowns(points) numbers for each.
struct PathBundle {
  int points = 8;
  std::vector<Pair> starts;
  std::vector<double> from;  ///< r of each start; all 1 if empty
  std::vector<int> line_of;  ///< the line of each path
  std::vector<ParameterLine> lines;
};

struct TrackedPaths {
  std::vector<Pair> ends;
  std::vector<PathEnd> how;
  std::vector<double> remaining;
  std::vector<int> steps;

  std::span<const Pair> end(int path, int points) const {
    const std::size_t size = unknowns(points);
    return std::span(ends).subspan(path * size, size);
  }
};

/// Follows each path by itself, so that the result depends on nothing but the kernel that is used.
TrackedPaths track(const PathBundle& bundle, const TrackingOptions& means);

/// What an inspection of roots finds; InspectTask says what each is.
struct Inspection {
  std::vector<Pair> values, changes;
  std::vector<double> conditions;
};

/// Newton's corrections and the conditions of roots (unknowns(points) numbers each) of `data`, by
/// values of the equations in double precision, or in about 32 digits if `extended`.
Inspection inspect(std::span<const Pair> roots, int points, const ParameterLine& data,
                   bool extended, const TrackingOptions& means);

}  // namespace cognate::synthesis::nine_point
