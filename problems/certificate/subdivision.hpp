/// @file The boxes that a proof discards, made anew depth first from the verdicts of the prover.
///
/// With its target fixed a verdict depends on its box alone, so the boxes are those of the proof
/// whatever the order. The prover only proposes them: that they cover the whole is counted here,
/// that they hold no better design is for others to show.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "analysis/numbers/parallel.hpp"
#include "synthesis/bounds/staged_search.hpp"

namespace cognate::problems {

struct SubdivisionOptions {
  std::size_t sample = 0;  ///< how many of the discarded boxes to keep
  std::uint64_t seed = 1;  ///< which: those with the least numbers, which depend on it
  int threads = 0;
  std::function<bool()> stop;
  std::function<void(double share)> progress;
};

inline constexpr int kMostHalvings = 256;  ///< deeper boxes would have sides of no width

template <class Box>
struct Subdivision {
  std::uint64_t boxes = 0;      ///< examined
  std::uint64_t discarded = 0;  ///< boxes that are not divided further
  bool complete = false;        ///< every box is divided or discarded
  bool covers = false;          ///< the volumes of those discarded add up to the whole, exactly
  std::vector<Box> sample;      ///< of the discarded, in an order that is random
};

/// Whether boxes of which `count[d]` have been halved d times add up to `roots` whole ones.
inline bool volumes_add_up(const std::array<std::uint64_t, kMostHalvings>& count,
                           std::uint64_t roots) {
  std::uint64_t halves = 0;
  for (int depth = kMostHalvings - 1; depth > 0; --depth) {
    halves += count[depth];
    if (halves % 2 != 0) return false;
    halves /= 2;
  }
  return halves + count[0] == roots;
}

template <class Box, class Judge, class Halves>
class Subdividing {
 public:
  Subdividing(const SubdivisionOptions& options, const Judge& judge, const Halves& halves)
      : options_(options), judge_(judge), halves_(halves) {}

  Subdivision<Box> run(const std::vector<Box>& roots) {
    Part all;
    std::uint64_t number = options_.seed;
    for (const Box& root : roots) all.open.push_back({root, 0, mixed(++number)});
    while (!all.open.empty() && all.open.size() < kSubtrees && !is_over()) step_all(all);
    std::vector<Part> parts(all.open.size());
    for (std::size_t i = 0; i < parts.size(); ++i) parts[i].open = {all.open[i]};
    double done = 0;
    parallel_for(static_cast<int>(parts.size()), options_.threads, [&](int i, int thread) {
      while (!parts[i].open.empty() && !parts[i].stuck && !is_over()) step(parts[i], kBatch);
      if (thread != 0) return;
      ++done;
      if (options_.progress) options_.progress(std::min(1.0, done * 2 / double(parts.size())));
    });
    all.open.clear();
    for (Part& part : parts) add(std::move(part), all);
    return finished(all, roots.size());
  }

 private:
  static constexpr std::size_t kBatch = 64, kSubtrees = 2048;
  struct Node {
    Box box;
    int depth = 0;
    std::uint64_t number = 0;
  };
  struct Part {
    std::vector<Node> open;
    std::vector<std::pair<std::uint64_t, Box>> kept;  ///< a heap, the greatest number first
    std::array<std::uint64_t, kMostHalvings> count{};
    std::uint64_t boxes = 0;
    bool stuck = false;
  };

  static std::uint64_t mixed(std::uint64_t z) {  // Steele, Lea & Flood 2014: SplitMix64
    z += 0x9e3779b97f4a7c15U;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
  }
  static bool is_less(const std::pair<std::uint64_t, Box>& a,
                      const std::pair<std::uint64_t, Box>& b) {
    return a.first < b.first;
  }

  bool is_over() const { return options_.stop && options_.stop(); }

  void keep(Part& part, std::uint64_t number, const Box& box) const {
    if (part.kept.size() == options_.sample) {
      if (part.kept.empty() || number > part.kept.front().first) return;
      std::ranges::pop_heap(part.kept, is_less);
      part.kept.pop_back();
    }
    part.kept.emplace_back(number, box);
    std::ranges::push_heap(part.kept, is_less);
  }

  /// Examines up to `most` of the open boxes, the last first.
  void step(Part& part, std::size_t most) const {
    const std::size_t count = std::min(most, part.open.size());
    std::vector<Node> nodes(part.open.end() - std::ptrdiff_t(count), part.open.end());
    part.open.resize(part.open.size() - count);
    std::vector<Box> boxes;
    for (const Node& node : nodes) boxes.push_back(node.box);
    std::vector<synthesis::StageVerdict> verdicts(count);
    judge_(std::span<const Box>(boxes), std::span<synthesis::StageVerdict>(verdicts));
    part.boxes += count;
    for (std::size_t i = 0; i < count; ++i) {
      const Node& node = nodes[i];
      if (verdicts[i].reached == 2) {
        ++part.count[node.depth];
        keep(part, node.number, node.box);
        continue;
      }
      if (verdicts[i].side < 0 || node.depth + 1 == kMostHalvings) {
        part.stuck = true;
        return;
      }
      const auto [first, second] = halves_(node.box, verdicts[i].side);
      part.open.push_back({first, node.depth + 1, mixed(node.number)});
      part.open.push_back({second, node.depth + 1, mixed(~node.number)});
    }
  }

  void step_all(Part& all) const {
    std::vector<Node> level = std::exchange(all.open, {});
    while (!level.empty() && !all.stuck) {
      Part batch;
      const std::size_t count = std::min(kBatch, level.size());
      batch.open.assign(level.end() - std::ptrdiff_t(count), level.end());
      level.resize(level.size() - count);
      step(batch, count);
      add(std::move(batch), all);
    }
  }

  void add(Part part, Part& all) const {
    all.boxes += part.boxes;
    all.stuck = all.stuck || part.stuck;
    all.open.insert(all.open.end(), part.open.begin(), part.open.end());
    for (int depth = 0; depth < kMostHalvings; ++depth) all.count[depth] += part.count[depth];
    for (const auto& [number, box] : part.kept) keep(all, number, box);
  }

  Subdivision<Box> finished(Part& all, std::uint64_t roots) const {
    Subdivision<Box> result{all.boxes, 0, !all.stuck && all.open.empty()};
    for (const std::uint64_t count : all.count) result.discarded += count;
    result.covers = volumes_add_up(all.count, roots);
    std::ranges::sort(all.kept, is_less);
    for (auto& [number, box] : all.kept) result.sample.push_back(std::move(box));
    return result;
  }

  const SubdivisionOptions& options_;
  const Judge& judge_;
  const Halves& halves_;
};

/// Divides `roots` until `judge(boxes, verdicts)` is done with all of them; `halves(box, side)` are
/// the two parts of a box.
template <class Box, class Judge, class Halves>
Subdivision<Box> subdivision(const std::vector<Box>& roots, const SubdivisionOptions& options,
                             const Judge& judge, const Halves& halves) {
  return Subdividing<Box, Judge, Halves>(options, judge, halves).run(roots);
}

}  // namespace cognate::problems
