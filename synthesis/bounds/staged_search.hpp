/// @file Depth-first branch and bound with fixed targets and a result that does not depend on the
/// number of threads.
///
/// With a fixed target the boxes examined do not depend on their order, so that a stack serves as
/// well as a heap of millions of boxes. A search that does not end proves nothing, though; so lower
/// targets are reached everywhere first, each a bound of its own. Boxes that reach one of these but
/// not the last target wait for the next stage: no box is examined twice.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <functional>
#include <iterator>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

#include "analysis/numbers/parallel.hpp"
#include "synthesis/bounds/branch_and_bound.hpp"

namespace cognate::synthesis {

/// What is known of the objective over a box: whether it reaches the last target (2, also where
/// nothing lies in the box), at least that of the stage (1), or neither (0).
struct StageVerdict {
  int reached = 0;
  int side = -1;  ///< which is best halved; −1: the box cannot be divided
};

struct StageOptions {
  std::vector<double> targets;         ///< ascending; each is reached everywhere before the next
  int threads = 0;                     ///< as in `thread_count`
  std::size_t most_boxes = 4'000'000;  ///< that wait for a stage at once; more ends the search
  std::function<bool()> stop;          ///< whether to end early; asked by all threads
  /// Called by the caller's thread now and then, with the share done, all stages taken for alike,
  /// and the bound reached.
  std::function<void(double share, double lower)> progress;
};

template <class Box, class Judge, class Halves>
class StagedSearch {
 public:
  /// `judge(boxes, target, first_target, verdicts)` for some boxes at a time; `halves(box, side)`
  /// gives the two parts of a box as a pair.
  StagedSearch(const StageOptions& options, const Judge& judge, const Halves& halves)
      : options_(options), judge_(judge), halves_(halves) {}

  BranchResult run(const std::vector<Box>& roots) {
    std::vector<Node> open;
    for (const Box& root : roots) open.push_back({root, -1, 1 / double(roots.size())});
    BranchResult result{0, false, 0};
    for (const double target : options_.targets) {
      target_ = target;
      lower_ = result.lower;
      open = search(std::move(open));
      result.boxes = boxes_;
      if (stopped_) return result;
      result.lower = target_;
      ++stage_;
    }
    result.complete = open.empty();
    return result;
  }

 private:
  static constexpr std::size_t kBatch = 64, kSubtrees = 4096, kGroup = 8;
  struct Node {
    Box box;
    int side = -1;  ///< to be halved; −1: not examined yet
    double share = 0;
  };
  struct Work {
    std::vector<Node> stack, waiting;
    std::uint64_t boxes = 0;
    double done = 0;
    bool stuck = false;
  };

  /// Examines up to `most` of the boxes on the stack, the last first, and puts their parts there.
  void step(Work& work, std::size_t most) const {
    std::vector<Box> boxes;
    std::vector<double> shares;
    while (!work.stack.empty() && boxes.size() + 2 <= most) {
      const Node node = std::move(work.stack.back());
      work.stack.pop_back();
      if (node.side < 0) {
        boxes.push_back(node.box);
        shares.push_back(node.share);
        continue;
      }
      const auto parts = halves_(node.box, node.side);
      for (const Box& part : {parts.first, parts.second}) {
        boxes.push_back(part);
        shares.push_back(0.5 * node.share);
      }
    }
    std::vector<StageVerdict> verdicts(boxes.size());
    judge_(std::span<const Box>(boxes), options_.targets.back(), target_,
           std::span<StageVerdict>(verdicts));
    work.boxes += boxes.size();
    for (std::size_t i = boxes.size(); i-- > 0;) {
      Node node{std::move(boxes[i]), verdicts[i].side, shares[i]};
      const bool last = target_ >= options_.targets.back();
      if (verdicts[i].reached == 2 || (last && verdicts[i].reached == 1)) {
        work.done += node.share;
      } else if (verdicts[i].reached == 1 && node.side >= 0) {
        work.done += node.share;
        work.waiting.push_back(std::move(node));
      } else if (node.side >= 0) {
        work.stack.push_back(std::move(node));
      } else {
        work.stuck = true;
      }
    }
  }

  /// Runs `body` of all `works` and takes up what they found, in their order. Behind one that is
  /// stuck none counts: those before it are ended, so that threads make no difference.
  template <class Body>
  void share_out(std::vector<Work>& works, std::vector<Node>& waiting, const Body& body) {
    std::mutex reporting;
    std::atomic<int> last{static_cast<int>(works.size())};
    parallel_for(static_cast<int>(works.size()), options_.threads, [&](int i, int thread) {
      const auto ends = [&] { return i > last || is_over(); };
      if (ends()) return;
      body(works[i], ends);
      const std::scoped_lock lock(reporting);
      if (works[i].stuck) last = std::min(last.load(), i);
      done_ += works[i].done;
      waiting_ += works[i].waiting.size();
      if (waiting_ > options_.most_boxes) stopped_ = true;
      if (thread == 0 && options_.progress) {
        options_.progress((stage_ + done_) / double(options_.targets.size()), lower_);
      }
    });
    for (int i = 0; i < static_cast<int>(works.size()); ++i) {
      if (i > last) break;
      boxes_ += works[i].boxes;
      waiting.insert(waiting.end(), std::make_move_iterator(works[i].waiting.begin()),
                     std::make_move_iterator(works[i].waiting.end()));
      works[i].waiting = {};
    }
    if (last < static_cast<int>(works.size())) stopped_ = true;
  }

  bool is_over() {
    if (!stopped_ && options_.stop && options_.stop()) stopped_ = true;
    return stopped_;
  }

  /// Brings all of `open` to the stage's target. What waits for the next stage.
  std::vector<Node> search(std::vector<Node> open) {
    std::vector<Node> waiting;
    waiting_ = 0;
    done_ = 1;
    for (const Node& node : open) done_ -= node.share;
    while (!open.empty() && open.size() < kSubtrees && !stopped_) {
      std::vector<Work> works = groups(open, kBatch / 2);
      share_out(works, waiting, [&](Work& work, const auto&) { step(work, kBatch); });
      open.clear();
      for (Work& work : works) {
        open.insert(open.end(), std::make_move_iterator(work.stack.begin()),
                    std::make_move_iterator(work.stack.end()));
      }
    }
    std::vector<Work> works = groups(open, kGroup);
    share_out(works, waiting, [&](Work& work, const auto& ends) {
      while (!work.stack.empty() && !work.stuck && !ends()) step(work, kBatch);
    });
    return waiting;
  }

  static std::vector<Work> groups(std::vector<Node>& open, std::size_t size) {
    std::vector<Work> works((open.size() + size - 1) / size);
    for (std::size_t i = 0; i < open.size(); ++i) {
      works[i / size].stack.push_back(std::move(open[i]));
    }
    return works;
  }

  const StageOptions& options_;
  const Judge& judge_;
  const Halves& halves_;
  double target_ = 0, lower_ = 0, done_ = 0;
  std::size_t waiting_ = 0;
  int stage_ = 0;
  std::uint64_t boxes_ = 0;
  std::atomic<bool> stopped_ = false;
};

/// Divides `roots` until every box reaches each of the targets, one after the other. The bound of
/// the result is the last target that all reached.
template <class Box, class Judge, class Halves>
BranchResult staged_search(const std::vector<Box>& roots, const StageOptions& options,
                           const Judge& judge, const Halves& halves) {
  return StagedSearch<Box, Judge, Halves>(options, judge, halves).run(roots);
}

}  // namespace cognate::synthesis
