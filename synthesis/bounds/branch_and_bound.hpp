/// @file Best-first branch and bound with a result that does not depend on the number of threads.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <vector>

#include "analysis/numbers/parallel.hpp"

namespace cognate::synthesis {

/// What is known of the objective over a box.
struct BoxBound {
  double least = 0;  ///< no more than the objective anywhere in the box; infinite: nothing there
  int split = -1;    ///< the side that is best halved; −1: the box cannot be divided
};

struct BranchOptions {
  double target = 0;                   ///< boxes whose bound reaches it are done with
  int threads = 0;                     ///< as in `thread_count`
  std::size_t most_boxes = 4'000'000;  ///< kept at once; more ends the search
  std::function<bool()> stop;          ///< whether to end early; asked between batches
  /// Called between batches with the share of the volume done and the bound reached.
  std::function<void(double share, double lower)> progress;
};

struct BranchResult {
  double lower = 0;         ///< no more than the objective anywhere, at most the target
  bool complete = false;    ///< nothing is left below the target
  std::uint64_t boxes = 0;  ///< examined
};

/// Divides `roots` until `bound(box)` reaches the target everywhere. The box of the least bound
/// goes first, in batches of fixed size; among equals the newest, so that few boxes wait while
/// little is known of them. `halves(box, side)` gives the
/// two parts of a box as a pair.
template <class Box, class Bound, class Halves>
BranchResult branch_and_bound(const std::vector<Box>& roots, const BranchOptions& options,
                              const Bound& bound, const Halves& halves) {
  constexpr std::size_t kBatch = 256;
  struct Node {
    Box box;
    double least = 0;
    double share = 0;  ///< of the whole volume
    std::uint64_t number = 0;
    int split = -1;
  };
  const auto later = [](const Node& a, const Node& b) {
    return a.least != b.least ? a.least > b.least : a.number < b.number;
  };
  std::vector<Node> heap, batch;
  BranchResult result{options.target, false, 0};
  double done = 0, stuck = options.target;  // the least bound of boxes that cannot be divided
  std::uint64_t number = 0;
  const auto examine = [&] {
    parallel_for(static_cast<int>(batch.size()), options.threads, [&](int i, int) {
      const BoxBound found = bound(batch[i].box);
      batch[i].least = std::max(batch[i].least, found.least);  // a part is no worse than its whole
      batch[i].split = found.split;
    });
    for (Node& node : batch) {
      ++result.boxes;
      if (node.least < options.target && node.split >= 0) {
        node.number = number++;
        heap.push_back(std::move(node));
        std::push_heap(heap.begin(), heap.end(), later);
        continue;
      }
      if (node.least < options.target) stuck = std::min(stuck, node.least);
      done += node.share;
    }
    batch.clear();
  };
  for (const Box& root : roots) batch.push_back({root, 0, 1 / double(roots.size())});
  examine();
  while (!heap.empty()) {
    const double lower = std::min(stuck, heap.front().least);
    if (options.progress) options.progress(done, lower);
    if ((options.stop && options.stop()) || heap.size() > options.most_boxes) {
      result.lower = lower;
      return result;
    }
    while (!heap.empty() && batch.size() < kBatch) {
      std::pop_heap(heap.begin(), heap.end(), later);
      const Node node = std::move(heap.back());
      heap.pop_back();
      const auto parts = halves(node.box, node.split);
      batch.push_back({parts.first, node.least, 0.5 * node.share});
      batch.push_back({parts.second, node.least, 0.5 * node.share});
    }
    examine();
  }
  result.lower = stuck;
  result.complete = stuck >= options.target;
  return result;
}

}  // namespace cognate::synthesis
