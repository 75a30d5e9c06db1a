#include "synthesis/exact/nine_point/start_set.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "analysis/numbers/constants.hpp"
#include "synthesis/exact/nine_point/refine.hpp"

namespace cognate::synthesis::nine_point {
namespace {

/// Roots closer than this, relative to their fingerprints, are the same.
constexpr double kSame = 1e-8;

class RandomNumbers {
 public:
  explicit RandomNumbers(unsigned seed) : engine_(seed) {}

  /// Evenly in [low, high); not by a distribution of the library, whose algorithm is its own.
  double real(double low, double high) {
    return low + (high - low) * std::ldexp(static_cast<double>(engine_() >> 11), -53);
  }
  /// Of modulus in [low, high) and any argument.
  Number complex(double low, double high) {
    const double modulus = real(low, high);
    return std::polar(modulus, real(0, kTurn));
  }
  void shuffle(std::span<int> order) {
    for (std::size_t i = order.size(); i > 1; --i) {
      std::swap(order[i - 1], order[static_cast<std::size_t>(real(0, static_cast<double>(i)))]);
    }
  }

 private:
  std::mt19937_64 engine_;
};

/// The displacement at which both dyads close once the coupler has turned by t: of the two, which
/// are the points where two circles meet, one.
void close(std::span<const Pair> root, const Number& t, Number& d, Number& d_bar) {
  const auto z = [&](int i) { return number(root[i]); };
  const Number u = z(0) * t - z(2), v = z(1) / t - z(3), square = (z(0) - z(2)) * (z(1) - z(3));
  const Number u2 = z(4) * t - z(6), v2 = z(5) / t - z(7), square2 = (z(4) - z(6)) * (z(5) - z(7));
  // (d + u)(d̄ + v) = square and the same with index 2; their difference is linear:
  // (v − v₂) d + (u − u₂) d̄ = right.
  const Number dv = v - v2, du = u - u2, right = (square - square2) - (u * v - u2 * v2);
  // With e = d + u: e ((right − dv (e − u))/du + v) = square.
  const Number middle = right + dv * u + du * v;
  const Number e = (middle + std::sqrt(middle * middle - 4.0 * dv * du * square)) / (2.0 * dv);
  d = e - u;
  d_bar = square / e - v;
}

/// A random linkage and its own positions, with displacements of root mean square 1.
StartSet random_seed(const PathClass& kind, RandomNumbers& random) {
  StartSet seed;
  seed.data.kind = kind;
  for (int i = 0; i < kPivots; ++i) seed.roots.push_back(pair(random.complex(0.5, 1.5)));
  const int poses = kind.poses - 1;
  for (int j = 0; j < poses + kind.points; ++j) {
    const Number t = random.complex(0.7, 1.4);
    if (j < poses) {
      seed.data.t.push_back(t);
    } else {
      seed.roots.push_back(pair(t));
    }
    Number d, d_bar;
    close(std::span(seed.roots).first(kPivots), t, d, d_bar);
    seed.data.d.push_back(d);
    seed.data.d_bar.push_back(d_bar);
  }
  return seed;
}

double root_mean_square(std::span<const Number> all) {
  double sum = 0;
  for (const Number& one : all) sum += std::norm(one);
  return std::sqrt(sum / static_cast<double>(all.size()));
}

/// The data with its plane multiplied by `scale` and the conjugate plane by `scale_bar`.
void rescale(PathParameters& data, const Number& scale, const Number& scale_bar) {
  for (Number& d : data.d) d *= scale;
  for (Number& d : data.d_bar) d *= scale_bar;
}
void rescale(std::span<Pair> root, const Number& scale, const Number& scale_bar) {
  for (int i = 0; i < kPivots; ++i) {
    root[i] = pair(number(root[i]) * (i % 2 == 0 ? scale : scale_bar));
  }
}

/// Data without a length that is much larger or smaller than the others: paths that begin there are
/// short. (Nearer to real data, where d̄ is the conjugate of d, they are longer.)
PathParameters random_data(const PathClass& kind, RandomNumbers& random) {
  PathParameters data{kind, {}, {}, {}};
  for (int j = 0; j < kind.poses - 1 + kind.points; ++j) {
    data.d.push_back(random.complex(0.7, 1.3));
    data.d_bar.push_back(random.complex(0.7, 1.3));
    if (j < kind.poses - 1) data.t.push_back(random.complex(0.8, 1.25));
  }
  return data;
}

/// A way to bring the positions into another order, by which solutions are exchanged.
struct Loop {
  std::vector<int> order;  ///< position j takes the place of position order[j]
  Number scale, scale_bar;

  Loop(const PathClass& kind, RandomNumbers& random) : order(kind.poses - 1 + kind.points) {
    std::iota(order.begin(), order.end(), 0);
    random.shuffle(std::span(order).first(kind.poses - 1));
    random.shuffle(std::span(order).subspan(kind.poses - 1));
    scale = random.complex(0.8, 1.25);
    scale_bar = random.complex(0.8, 1.25);
  }

  PathParameters end(const PathParameters& data) const {
    PathParameters moved = data;
    const std::size_t poses = data.t.size();
    for (std::size_t j = 0; j < order.size(); ++j) {
      moved.d[j] = data.d[order[j]];
      moved.d_bar[j] = data.d_bar[order[j]];
      if (j < poses) moved.t[j] = data.t[order[j]];
    }
    rescale(moved, scale, scale_bar);
    return moved;
  }

  /// The end of a path as a solution of the data at its start.
  RootNumbers back(std::span<const Pair> end, int poses) const {
    RootNumbers root(end.begin(), end.end());
    rescale(root, 1.0 / scale, 1.0 / scale_bar);
    for (std::size_t j = poses; j < order.size(); ++j) {
      root[kPivots + order[j] - poses] = end[kPivots + j - poses];
    }
    return root;
  }
};

class Monodromy {
 public:
  Monodromy(StartSet seed, const TrackingOptions& means, MonodromyCounts& counts)
      : set_(std::move(seed)), means_(means), counts_(counts) {
    index_.add(fingerprint(set_.data.kind, set_.root(0)));
  }

  void add_loop(Loop loop) {
    lines_.push_back(parameter_line(set_.data, loop.end(set_.data)));
    loops_.push_back(std::move(loop));
    tried_.push_back(0);
  }

  /// Follows all loops from all solutions that have not gone there. False when stopped.
  bool round() {
    PathBundle bundle;
    bundle.points = set_.data.kind.points;
    bundle.lines = lines_;
    const int known = set_.count();
    for (std::size_t loop = 0; loop < loops_.size(); ++loop) {
      for (int& i = tried_[loop]; i < known; ++i) {
        const auto root = set_.root(i);
        bundle.starts.insert(bundle.starts.end(), root.begin(), root.end());
        bundle.line_of.push_back(static_cast<int>(loop));
      }
    }
    const TrackedPaths paths = track(bundle, means_);
    ++counts_.rounds;
    for (std::size_t path = 0; path < paths.how.size(); ++path) {
      ++counts_.paths;
      if (paths.how[path] == PathEnd::unfinished) return false;
      if (paths.how[path] != PathEnd::reached) {
        ++counts_.failed;
        continue;
      }
      collect(loops_[bundle.line_of[path]].back(paths.end(static_cast<int>(path), bundle.points),
                                                set_.data.kind.poses - 1));
    }
    return true;
  }

  const StartSet& set() const { return set_; }

 private:
  void collect(const RootNumbers& root) {
    const Fingerprint print = fingerprint(set_.data.kind, root);
    if (index_.find(print, kSame) >= 0) return;
    index_.add(print);
    set_.roots.insert(set_.roots.end(), root.begin(), root.end());
  }

  StartSet set_;
  const TrackingOptions& means_;
  MonodromyCounts& counts_;
  FingerprintIndex index_;
  std::vector<Loop> loops_;
  std::vector<ParameterLine> lines_;
  std::vector<int> tried_;  ///< for each loop the number of solutions that have gone there
};

}  // namespace

int known_count(const PathClass& kind) {
  constexpr int kCounts[] = {1442, 1112, 201, 30, 6};
  const bool in_family =
      kind.poses >= 1 && kind.points >= 0 && 2 * (kind.poses - 1) + kind.points == kPositions;
  return in_family ? kCounts[kind.poses - 1] : 0;
}

std::optional<StartSet> find_start_set(const PathClass& kind, const TrackingOptions& means,
                                       MonodromyCounts* counts, unsigned seed) {
  RandomNumbers random(seed);
  MonodromyCounts own;
  MonodromyCounts& counted = counts ? *counts : own;
  StartSet first = random_seed(kind, random);
  const Number scale = 1 / root_mean_square(first.data.d);
  const Number scale_bar = 1 / root_mean_square(first.data.d_bar);
  rescale(first.data, scale, scale_bar);
  rescale(std::span(first.roots), scale, scale_bar);
  const PathParameters data = random_data(kind, random);
  const PathBundle to_data{kind.points, first.roots, {}, {0}, {parameter_line(first.data, data)}};
  const TrackedPaths path = track(to_data, means);
  if (path.how[0] != PathEnd::reached) return std::nullopt;
  first = {data, path.ends};

  Monodromy monodromy(std::move(first), means, counted);
  constexpr int kMostLoops = 12;
  for (int loops = 0; loops < kMostLoops && monodromy.set().count() < known_count(kind);) {
    monodromy.add_loop(Loop(kind, random));
    if (++loops < 2) continue;
    for (int known = 0; known < monodromy.set().count();) {
      known = monodromy.set().count();
      if (!monodromy.round()) return std::nullopt;
      if (monodromy.set().count() >= known_count(kind)) break;
    }
  }
  StartSet set = monodromy.set();
  refine(set.roots, set.data, means);
  return set;
}

}  // namespace cognate::synthesis::nine_point
