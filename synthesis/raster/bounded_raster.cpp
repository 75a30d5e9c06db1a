#include "synthesis/raster/bounded_raster.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>

namespace cognate::synthesis {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();
/// Boxes examined between two looks at the clock.
constexpr std::uint64_t kBoxesOfRound = 256;

double rounded_merit(double value) {
  return std::round(value / kSameMerit);
}

bool is_better(const BoundedRasterResult::Kept& a, const BoundedRasterResult::Kept& b) {
  const auto key = [](const BoundedRasterResult::Kept& kept) {
    return std::tuple(rounded_merit(kept.merit.error), rounded_merit(kept.merit.second),
                      kept.merit.size);
  };
  const auto left = key(a), right = key(b);
  return left != right ? left < right : a.at < b.at;
}

double combinations_in(const RasterBox& box) {
  double size = 1;
  for (std::size_t i = 0; i < box.first.size(); ++i) {
    size *= static_cast<double>(box.last[i] - box.first[i] + 1);
  }
  return size;
}

class BoundedSearch {
 public:
  BoundedSearch(const BoundedRaster& task, const BoundedRasterOptions& options)
      : task_(task), options_(options) {}

  BoundedRasterResult run() {
    RasterBox whole;
    for (const RasterAxis& axis : task_.axes()) {
      whole.first.push_back(0);
      whole.last.push_back(axis.values.count() - 1);
    }
    result_.combinations = combinations_in(whole);
    examine(std::move(whole), 0);
    while (!open_.empty() && !is_over()) {
      const Node node = open_.top();
      open_.pop();
      if (is_excluded(node.bound)) {
        result_.covered += combinations_in(node.box);
        continue;
      }
      divide(node);
    }
    finish();
    return std::move(result_);
  }

 private:
  struct Node {
    double bound = 0;
    std::uint64_t number = 0;
    RasterBox box;
  };
  struct IsLater {
    bool operator()(const Node& a, const Node& b) const {
      const double left = rounded_merit(a.bound), right = rounded_merit(b.bound);
      return left != right ? left > right : a.number < b.number;
    }
  };

  bool is_over() {
    if (result_.boxes >= options_.most_boxes) return true;
    if (result_.boxes - looked_ < kBoxesOfRound) return false;
    looked_ = result_.boxes;
    if (options_.progress) {
      options_.progress(result_.covered / result_.combinations,
                        result_.best.empty() ? kNone : result_.best.front().merit.error);
    }
    return options_.deadline != nullptr && options_.deadline->reached();
  }

  bool is_full() const { return result_.best.size() == options_.designs; }

  bool is_excluded(double bound) const {
    if (bound == kNone) return true;
    return is_full() &&
           rounded_merit(bound - kSameMerit) > rounded_merit(result_.best.back().merit.error);
  }

  void examine(RasterBox box, double parent) {
    ++result_.boxes;
    const double bound = std::max(parent, task_.bound(box));
    if (is_excluded(bound)) {
      result_.covered += combinations_in(box);
    } else if (box.is_single()) {
      result_.covered += 1;
      ++result_.evaluated;
      consider(box.first);
    } else {
      open_.push({bound, ++number_, std::move(box)});
    }
  }

  void divide(const Node& node) {
    const std::size_t axis = widest(node.box);
    const std::int64_t middle =
        node.box.first[axis] + (node.box.last[axis] - node.box.first[axis]) / 2;
    RasterBox lower = node.box, upper = node.box;
    lower.last[axis] = middle;
    upper.first[axis] = middle + 1;
    examine(std::move(lower), node.bound);
    examine(std::move(upper), node.bound);
  }

  std::size_t widest(const RasterBox& box) const {
    std::size_t widest = 0;
    double most = -1;
    for (std::size_t i = 0; i < box.first.size(); ++i) {
      if (box.first[i] == box.last[i]) continue;
      const RasterValues& values = task_.axes()[i].values;
      const double width = (values.at(box.last[i]) - values.at(box.first[i])) * task_.weight(i);
      if (width > most) std::tie(widest, most) = std::pair(i, width);
    }
    return widest;
  }

  /// Keeps a combination if it is among the best, in place of the same design where that is worse.
  void consider(const RasterNumbers& at) {
    const auto merit = task_.evaluate(at);
    if (!merit) return;
    BoundedRasterResult::Kept made{at, *merit};
    auto& best = result_.best;
    if (is_full() && !is_better(made, best.back())) return;
    const auto same = std::ranges::find_if(
        best, [&](const auto& kept) { return task_.is_same(kept.at, made.at); });
    if (same != best.end() && !is_better(made, *same)) return;
    if (!task_.accepts(at)) return;
    if (same != best.end()) best.erase(same);
    best.insert(std::ranges::upper_bound(best, made, is_better), std::move(made));
    if (best.size() > options_.designs) best.pop_back();
  }

  void finish() {
    double open = kNone;
    while (!open_.empty()) {
      const Node& node = open_.top();
      if (is_excluded(node.bound)) {
        result_.covered += combinations_in(node.box);
      } else {
        open = std::min(open, node.bound);
      }
      open_.pop();
    }
    result_.is_complete = open == kNone;
    const double best = result_.best.empty() ? kNone : result_.best.front().merit.error;
    result_.bound = std::min(open, best);
  }

  const BoundedRaster& task_;
  const BoundedRasterOptions& options_;
  BoundedRasterResult result_;
  std::priority_queue<Node, std::vector<Node>, IsLater> open_;
  std::uint64_t number_ = 0, looked_ = 0;
};

}  // namespace

BoundedRasterResult search_bounded_raster(const BoundedRaster& task,
                                          const BoundedRasterOptions& options) {
  return BoundedSearch(task, options).run();
}

}  // namespace cognate::synthesis
