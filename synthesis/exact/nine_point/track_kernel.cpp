// Follows the paths of a homotopy, one in each lane. Compiled once for each instruction set and for
// double-double numbers: COGNATE_ISA names it, see numbers.hpp.
#include "synthesis/exact/nine_point/track_kernel.hpp"

#include <cstdint>
#include <cstring>

#include "synthesis/exact/nine_point/inspector.hpp"
#include "synthesis/exact/nine_point/lane_state.hpp"

namespace cognate::synthesis::nine_point::COGNATE_ISA {
namespace {

/// x^(1/kOrder) within some per cent, from the exponent and the leading bits.
double root_of_order(double x) {
  constexpr std::int64_t kOne = 0x3ff0000000000000;
  std::int64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  bits = (bits - kOne) / kOrder + kOne;
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

// Corrections below are rounding errors of well-conditioned roots; others do not get so far.
constexpr double kStall = 4e-15;
constexpr int kMostPolishing = 3;

/// The path of one lane, and how its steps are chosen.
struct LanePath {
  int path = -1;
  double r = 1;
  double step = 0;       ///< that is attempted next
  double reach = 1;      ///< how much longer steps may be than the series says
  double suggested = 0;  ///< by the series alone
  int steps = 0;
  int polished = 0;  ///< corrections at the end of the path

  double target() const { return step >= r ? 0 : r - step; }
};

class Tracker {
 public:
  explicit Tracker(const TrackTask& task) : task_(task), state_(task.points) {}

  void run() {
    for (int lane = 0; lane < kLanes; ++lane) refill(lane);
    for (long round = 1; active_ > 0; ++round) {
      advance();
      if (round % 32 == 0 && task_.stopped(task_.context)) return abandon();
    }
  }

 private:
  void refill(int lane) {
    LanePath& on = paths_[lane];
    on = LanePath();
    on.path = task_.next(task_.context);
    if (on.path < 0) return;
    ++active_;
    on.r = task_.from[on.path];
    state_.put(lane, task_.starts + on.path * unknowns(task_.points),
               task_.lines[task_.line_of[on.path]]);
  }

  void advance() {
    double step[kLanes], r[kLanes], accepted[kLanes];
    for (int lane = 0; lane < kLanes; ++lane) {
      step[lane] = paths_[lane].step;
      r[lane] = paths_[lane].target();
    }
    state_.attempt(step, r, sizes_);
    for (int lane = 0; lane < kLanes; ++lane) accepted[lane] = judge(paths_[lane], lane) ? 1 : 0;
    state_.go_on(accepted, sizes_);
    for (int lane = 0; lane < kLanes; ++lane) {
      if (paths_[lane].path >= 0) proceed(lane, accepted[lane] > 0);
    }
  }

  bool judge(const LanePath& on, int lane) const {
    const TrackSettings& set = task_.settings;
    const double first = sizes_.first[lane], second = sizes_.second[lane];
    return on.path >= 0 && first <= set.correction &&
           (second <= set.noise || second <= set.contraction * first);
  }

  /// Decides about the next step of a lane, or ends its path.
  void proceed(int lane, bool accepted) {
    const TrackSettings& set = task_.settings;
    LanePath& on = paths_[lane];
    ++on.steps;
    if (accepted) {
      on.r = on.target();
      if (on.r <= 0) return polish(lane);
      if (sizes_.greatest[lane] > set.infinite) return end(lane, PathEnd::infinite);
      on.suggested = root_of_order(set.prediction / sizes_.highest[lane]);
      // The correction shows how good the prediction really was.
      if (on.step > 0) {
        if (sizes_.first[lane] < 0.1 * set.prediction) on.reach *= 1.15;
        if (sizes_.first[lane] > set.prediction) on.reach *= 0.85;
      }
      on.step = on.reach * on.suggested;
    } else if (on.r <= 0) {
      return end(lane, PathEnd::reached);
    } else {
      on.reach *= 0.5;
      on.step *= 0.5;
    }
    if (on.step > on.r) on.step = on.r;
    const bool tiny = !(on.step > set.least_step);
    if (tiny || on.steps >= set.most_steps) end(lane, PathEnd::stuck);
  }

  /// Ends a path that is there, unless another correction can still improve it.
  void polish(int lane) {
    LanePath& on = paths_[lane];
    const bool stalls = sizes_.second[lane] <= kStall || on.polished == kMostPolishing;
    if (stalls) return end(lane, PathEnd::reached);
    ++on.polished;
    on.step = 0;
  }

  void end(int lane, PathEnd how) {
    const int path = paths_[lane].path;
    state_.get(lane, task_.ends + path * unknowns(task_.points));
    task_.how[path] = how;
    task_.remaining[path] = paths_[lane].r;
    task_.steps[path] = paths_[lane].steps;
    --active_;
    refill(lane);
  }

  void abandon() {
    for (int lane = 0; lane < kLanes; ++lane) {
      if (paths_[lane].path >= 0) task_.how[paths_[lane].path] = PathEnd::unfinished;
    }
  }

  const TrackTask& task_;
  LaneState state_;
  LanePath paths_[kLanes];
  StepSizes sizes_;
  int active_ = 0;
};

}  // namespace

void track(const TrackTask& task) {
  Tracker tracker(task);
  tracker.run();
}

void inspect(const InspectTask& task) {
  Inspector(task).run();
}

}  // namespace cognate::synthesis::nine_point::COGNATE_ISA
