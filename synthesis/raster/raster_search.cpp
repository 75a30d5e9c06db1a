#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "analysis/numbers/parallel.hpp"
#include "synthesis/raster/incumbents.hpp"
#include "synthesis/raster/raster.hpp"

namespace cognate::synthesis {
namespace {

/// Boxes divided, and combinations evaluated, between two looks at the clock: fixed, so that the
/// result does not depend on the number of threads.
constexpr std::size_t kDivided = 32, kEvaluated = 1024;
/// Numbers of values this near to a whole one are on the raster.
constexpr double kOnRaster = 1e-7;
/// Share of the progress at which the search of the best combinations begins.
constexpr double kSearchBegins = 0.5;
/// A box whose minimum is better than the best combination by less of it is covered.
constexpr double kWorthwhile = 1e-9;

using Minima = std::vector<RasterPoint>;

struct RasterNode {
  RasterBox box;
  std::shared_ptr<const Minima> minima;  ///< best first, within limits
  double bound = 0;
  double size = 1;  ///< combinations
  std::uint64_t number = 0;
};

double size_of(const RasterBox& box) {
  double size = 1;
  for (std::size_t i = 0; i < box.first.size(); ++i) {
    size *= static_cast<double>(box.last[i] - box.first[i] + 1);
  }
  return size;
}

class RasterSearch {
 public:
  RasterSearch(const RasterTask& task, const RasterOptions& options)
      : task_(task), options_(options), best_(task, options) {
    for (const RasterAxis& axis : task.axes()) {
      whole_.first.push_back(0);
      whole_.last.push_back(axis.values.count() - 1);
    }
    result_.combinations = size_of(whole_);
  }

  RasterResult run(std::span<const RasterPoint> from) {
    Minima roots = task_.relax(whole_, from);
    ++result_.boxes;
    keep_best(roots);
    if (!roots.empty()) {
      result_.relaxed = roots.front();
      result_.rounded = best_.best_of(task_.evaluate(rounded(roots.front()), roots));
      result_.rounded_is_accepted = result_.rounded && best_.meets_all(*result_.rounded);
    }
    for (const RasterPoint& point : options_.known) {
      best_.consider({rounded(point)}, std::span(&point, 1));
    }
    if (result_.combinations <= options_.enumerate) {
      enumerate(roots.empty() ? Minima(from.begin(), from.end()) : roots);
    } else {
      branch(std::move(roots));
    }
    if (options_.search) search_best();
    result_.ended_early = is_over();
    result_.designs = best_.take();
    result_.evaluated = best_.evaluated();
    return std::move(result_);
  }

 private:
  bool is_over() const { return options_.deadline && options_.deadline->reached(); }

  void report() const {
    if (!options_.progress) return;
    const double covered = result_.covered / result_.combinations;
    options_.progress(options_.search ? kSearchBegins * covered : covered, best_.objective());
  }

  /// Objectives from this on are no better than what is known.
  double cutoff() const {
    const double best = best_.objective();
    return std::isfinite(best) ? best - std::max(kWorthwhile * best, options_.met) : best;
  }

  /// Leaves those within limits, best first.
  void keep_best(Minima& minima) const {
    std::erase_if(minima, [&](const RasterPoint& point) {
      return !(point.violation <= options_.feasibility) || !std::isfinite(point.objective);
    });
    std::ranges::stable_sort(minima, {}, &RasterPoint::objective);
    if (minima.size() > options_.minima) minima.resize(options_.minima);
  }

  RasterNumbers rounded(const RasterPoint& point) const {
    RasterNumbers at;
    const auto axes = task_.axes();
    for (std::size_t i = 0; i < axes.size(); ++i) {
      at.push_back(axes[i].values.nearest(point.values[i]));
    }
    return at;
  }

  void enumerate(const Minima& from) {
    RasterNumbers next = whole_.first;
    bool is_left = true;
    while (is_left && !is_over()) {
      std::vector<RasterNumbers> block;
      while (is_left && block.size() < kEvaluated) {
        block.push_back(next);
        is_left = advance(next);
      }
      best_.consider(block, from);
      result_.covered += static_cast<double>(block.size());
      report();
    }
    result_.is_complete = result_.is_enumerated = !is_left;
    result_.bound = best_.objective();
    if (is_left) result_.bound = result_.relaxed ? result_.relaxed->objective : 0;
  }

  void search_best() {
    const std::vector<RasterNumbers> all =
        result_.combinations <= static_cast<double>(options_.searched) ? combinations()
                                                                       : best_.promising();
    std::vector<std::optional<Minima>> found(all.size());
    parallel_for(static_cast<int>(all.size()), options_.threads, [&](int index, int thread) {
      if (is_over()) return;
      const auto i = static_cast<std::size_t>(index);
      found[i] = options_.search(all[i]);
      if (thread != 0 || !options_.progress) return;
      const double done = double(index + 1) / double(all.size());
      options_.progress(kSearchBegins + (1 - kSearchBegins) * done, best_.objective());
    });
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (!found[i]) continue;
      best_.add(all[i], *std::move(found[i]));
      ++result_.searched;
    }
    result_.bound = std::min(result_.bound, best_.objective());
  }

  /// All of them.
  std::vector<RasterNumbers> combinations() const {
    std::vector<RasterNumbers> all{whole_.first};
    for (RasterNumbers next = whole_.first; advance(next);) all.push_back(next);
    return all;
  }

  /// To the next combination; false after the last.
  bool advance(RasterNumbers& at) const {
    for (std::size_t i = 0; i < at.size(); ++i) {
      if (at[i] < whole_.last[i]) {
        ++at[i];
        return true;
      }
      at[i] = whole_.first[i];
    }
    return false;
  }

  void branch(Minima roots) {
    std::vector<RasterNumbers> first;
    for (const RasterPoint& root : roots) first.push_back(rounded(root));
    best_.consider(first, roots);
    for (const RasterPoint& root : roots) dive(root);
    best_.improve([&] { return is_over(); });
    relax_from_best(roots);
    if (roots.empty()) {
      finish();
      return;
    }
    add({whole_, std::make_shared<const Minima>(std::move(roots))});
    while (!open_.empty() && result_.boxes < options_.most_nodes && !is_over()) {
      divide_some();
      report();
    }
    finish();
  }

  /// A combination better than every minimum says that one was not found: the minimum next to it.
  void relax_from_best(Minima& roots) {
    if (best_.empty() || (!roots.empty() && roots.front().objective <= best_.objective())) return;
    const RasterPoint best = best_.best();
    Minima found = task_.relax(whole_, std::span(&best, 1));
    ++result_.boxes;
    roots.insert(roots.end(), found.begin(), found.end());
    roots.push_back(best);
    keep_best(roots);
    result_.relaxed = roots.front();
  }

  void finish() {
    result_.is_complete = open_.empty() && result_.relaxed.has_value();
    Minima last;
    if (result_.relaxed) last.push_back(*result_.relaxed);
    relax_from_best(last);
    result_.bound = best_.objective();
    if (!open_.empty()) result_.bound = std::min(result_.bound, open_.front().bound);
  }

  static bool comes_later(const RasterNode& a, const RasterNode& b) {
    return a.bound != b.bound ? a.bound > b.bound : a.number < b.number;
  }

  void add(RasterNode node) {
    node.bound = node.minima->front().objective;
    node.size = size_of(node.box);
    if (node.bound >= cutoff()) {
      result_.covered += node.size;
      return;
    }
    node.number = number_++;
    open_.push_back(std::move(node));
    std::ranges::push_heap(open_, comes_later);
  }

  /// Divides the boxes of the least bounds.
  void divide_some() {
    std::vector<RasterNode> halves;
    while (!open_.empty() && halves.size() < 2 * kDivided) {
      std::ranges::pop_heap(open_, comes_later);
      RasterNode node = std::move(open_.back());
      open_.pop_back();
      if (node.bound >= cutoff()) {
        result_.covered += node.size;
        continue;
      }
      for (RasterNode& half : halves_of(node)) halves.push_back(std::move(half));
    }
    std::vector<Minima> found(halves.size());
    parallel_for(static_cast<int>(halves.size()), options_.threads, [&](int i, int) {
      const auto k = static_cast<std::size_t>(i);
      if (!halves[k].box.is_single()) found[k] = minima_of(halves[k]);
    });
    settle(halves, found);
  }

  Minima minima_of(const RasterNode& half) const {
    Minima inside, outside;
    for (const RasterPoint& point : *half.minima) {
      (contains(half.box, point) ? inside : outside).push_back(point);
    }
    Minima all = task_.relax(half.box, outside);
    all.insert(all.end(), inside.begin(), inside.end());
    keep_best(all);
    return all;
  }

  /// Takes up what was found in the halves: combinations first, which may cover boxes.
  void settle(std::vector<RasterNode>& halves, std::vector<Minima>& found) {
    const double before = best_.objective();
    for (std::size_t k = 0; k < halves.size(); ++k) {
      ++result_.boxes;
      if (halves[k].box.is_single()) {
        best_.consider({halves[k].box.first}, *halves[k].minima);
      } else if (!found[k].empty() && found[k].front().objective < cutoff()) {
        best_.consider({rounded(found[k].front())}, found[k]);
      }
    }
    if (best_.objective() < before) best_.improve([&] { return is_over(); });
    for (std::size_t k = 0; k < halves.size(); ++k) {
      if (halves[k].box.is_single() || found[k].empty()) {
        result_.covered += size_of(halves[k].box);
      } else {
        add({std::move(halves[k].box), std::make_shared<const Minima>(std::move(found[k]))});
      }
    }
  }

  bool contains(const RasterBox& box, const RasterPoint& point) const {
    const auto axes = task_.axes();
    for (std::size_t i = 0; i < axes.size(); ++i) {
      const double at = axes[i].values.position(point.values[i]);
      if (at < static_cast<double>(box.first[i]) - kOnRaster) return false;
      if (at > static_cast<double>(box.last[i]) + kOnRaster) return false;
    }
    return true;
  }

  /// Two halves, between the two values where the best minimum lies; of one on the raster, which
  /// is no design that is accepted, on either side of it along the longest axis.
  std::array<RasterNode, 2> halves_of(const RasterNode& node) const {
    const auto axes = task_.axes();
    const RasterPoint& best = node.minima->front();
    std::size_t axis = 0, longest = 0;
    double farthest = -1;
    std::int64_t below = 0;
    for (std::size_t i = 0; i < axes.size(); ++i) {
      const std::int64_t first = node.box.first[i], last = node.box.last[i];
      if (last - first > node.box.last[longest] - node.box.first[longest]) longest = i;
      if (first == last) continue;
      const double at = std::clamp(axes[i].values.position(best.values[i]),
                                   static_cast<double>(first), static_cast<double>(last));
      const double low = std::floor(at), between = std::min(at - low, low + 1 - at);
      if (between <= farthest) continue;
      farthest = between;
      axis = i;
      below = static_cast<std::int64_t>(low);
    }
    if (farthest <= kOnRaster) {
      axis = longest;
      below = axes[axis].values.nearest(best.values[axis]);
    }
    below = std::clamp(below, node.box.first[axis], node.box.last[axis] - 1);
    std::array<RasterNode, 2> halves{node, node};
    halves[0].box.last[axis] = below;
    halves[1].box.first[axis] = below + 1;
    return halves;
  }

  /// Fixes one axis after the other, that first whose value is nearest to the raster, and finds the
  /// minimum of the rest each time.
  void dive(const RasterPoint& root) {
    const auto axes = task_.axes();
    RasterBox box = whole_;
    Minima at{root};
    while (!box.is_single() && !is_over()) {
      std::size_t axis = axes.size();
      double nearest = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < axes.size(); ++i) {
        if (box.first[i] == box.last[i]) continue;
        const double number = axes[i].values.position(at.front().values[i]);
        const double away = std::abs(number - std::round(number));
        if (away >= nearest) continue;
        nearest = away;
        axis = i;
      }
      box.first[axis] = box.last[axis] = axes[axis].values.nearest(at.front().values[axis]);
      Minima next = task_.relax(box, at);
      ++result_.boxes;
      keep_best(next);
      if (next.empty()) return;
      at = std::move(next);
    }
    best_.consider({box.first}, at);
  }

  const RasterTask& task_;
  const RasterOptions& options_;
  RasterBox whole_;
  RasterResult result_;
  RasterIncumbents best_;
  std::vector<RasterNode> open_;  ///< a heap, the least bound first
  std::uint64_t number_ = 0;
};

}  // namespace

RasterResult together(RasterResult a, RasterResult b) {
  const auto objective = [](const std::optional<RasterPoint>& point) {
    return point ? point->objective : std::numeric_limits<double>::infinity();
  };
  if (objective(b.relaxed) < objective(a.relaxed)) {
    a.relaxed = std::move(b.relaxed);
    a.rounded = std::move(b.rounded);
    a.rounded_is_accepted = b.rounded_is_accepted;
  }
  a.designs.insert(a.designs.end(), b.designs.begin(), b.designs.end());
  std::ranges::stable_sort(a.designs, {}, &RasterPoint::objective);
  a.bound = std::min(a.bound, b.bound);
  a.is_complete = a.is_complete && b.is_complete;
  a.is_enumerated = a.is_enumerated && b.is_enumerated;
  a.combinations += b.combinations;
  a.covered += b.covered;
  a.evaluated += b.evaluated;
  a.boxes += b.boxes;
  a.searched += b.searched;
  a.ended_early = a.ended_early || b.ended_early;
  return a;
}

RasterResult search_raster(const RasterTask& task, std::span<const RasterPoint> from,
                           const RasterOptions& options) {
  return RasterSearch(task, options).run(from);
}

}  // namespace cognate::synthesis
