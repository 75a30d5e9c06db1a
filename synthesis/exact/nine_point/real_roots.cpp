#include "synthesis/exact/nine_point/real_roots.hpp"

#include <algorithm>
#include <cmath>

namespace cognate::synthesis::nine_point {
namespace {

/// A root as near as this to its conjugate, relative to 1 + |unknown|, is its own conjugate if no
/// other root is.
constexpr double kOwnConjugate = 1e-6;
/// A conjugate is confirmed if Newton's method changes it by less.
constexpr double kConfirmed = 1e-6;
/// Rounding of the data moves a root of such condition by its own size.
constexpr double kSingular = 1e15;
/// Beyond, a linkage is not distinguished from one that misses its points.
constexpr double kMissed = 1e-9;

/// The conjugate problem has the conjugate roots, with plain and barred unknowns exchanged.
RootNumbers conjugate(std::span<const Pair> root) {
  RootNumbers partner(root.begin(), root.end());
  for (int i = 0; i < kPivots; ++i) partner[i] = pair(std::conj(number(root[i ^ 1])));
  for (std::size_t i = kPivots; i < root.size(); ++i) {
    partner[i] = pair(1.0 / std::conj(number(root[i])));
  }
  return partner;
}

Fingerprint conjugate(const Fingerprint& print) {
  return {std::conj(print.barred), std::conj(print.plain), print.size};
}

bool is_own_conjugate(std::span<const Pair> root) {
  const RootNumbers partner = conjugate(root);
  for (std::size_t i = 0; i < root.size(); ++i) {
    const Number z = number(root[i]);
    const double scale = i < kPivots ? 1 + std::abs(z) : std::abs(z);
    if (!(std::abs(z - number(partner[i])) <= kOwnConjugate * scale)) return false;
  }
  return true;
}

/// The mean of a root and its conjugate, whose rotations have modulus 1.
void make_real(std::span<Pair> root) {
  for (int i = 0; i < kPivots; i += 2) {
    const Number mean = 0.5 * (number(root[i]) + std::conj(number(root[i + 1])));
    root[i] = pair(mean);
    root[i + 1] = pair(std::conj(mean));
  }
  for (std::size_t i = kPivots; i < root.size(); ++i) {
    root[i] = pair(number(root[i]) / std::abs(number(root[i])));
  }
}

class Closure {
 public:
  Closure(FollowedPaths& paths, const PathParameters& data, const TrackingOptions& means)
      : paths_(paths), data_(data), means_(means), size_(unknowns(data.kind.points)) {}

  std::vector<RealRoot> run() {
    quality_ = refine(paths_.roots, data_, means_);
    drop_singular();
    for (std::size_t i = 0; i < quality_.size(); ++i) add_print(i);
    complete();
    find_real();
    return collect();
  }

 private:
  std::span<Pair> root(std::size_t i) { return std::span(paths_.roots).subspan(i * size_, size_); }

  /// Takes out ends of paths that are no isolated roots.
  void drop_singular() {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < quality_.size(); ++i) {
      const RootQuality& one = quality_[i];
      if (!(one.condition < kSingular && one.correction < kConfirmed && one.residual < kMissed)) {
        ++paths_.singular;
        continue;
      }
      std::copy_n(root(i).begin(), size_, root(kept).begin());
      quality_[kept++] = one;
    }
    quality_.resize(kept);
    paths_.roots.resize(kept * size_);
  }

  void add_print(std::size_t i) { index_.add(fingerprint(data_.kind, root(i))); }

  /// Adds the conjugates of roots that are known alone, if Newton's method stays there.
  void complete() {
    const std::size_t known = quality_.size();
    for (std::size_t i = 0; i < known && paths_.lost + paths_.duplicates > 0; ++i) {
      const Fingerprint print = fingerprint(data_.kind, root(i));
      if (index_.find(conjugate(print), kSameRoot) >= 0) continue;
      RootNumbers partner = conjugate(root(i));
      const RootQuality quality = refine(partner, data_, means_)[0];
      const Fingerprint found = fingerprint(data_.kind, partner);
      if (!(quality.correction < kConfirmed) || !(quality.residual < kMissed) ||
          index_.find(found, kSameRoot) >= 0) {
        continue;
      }
      index_.add(found);
      paths_.roots.insert(paths_.roots.end(), partner.begin(), partner.end());
      quality_.push_back(quality);
      --(paths_.lost > 0 ? paths_.lost : paths_.duplicates);
    }
  }

  /// Marks the real roots, and refines them once more where they are exactly real.
  void find_real() {
    std::vector<Pair> real;
    std::vector<std::size_t> which;
    for (std::size_t i = 0; i < quality_.size(); ++i) {
      const int partner = index_.find(conjugate(fingerprint(data_.kind, root(i))), kSameRoot);
      const bool another = partner >= 0 && partner != static_cast<int>(i);
      if (another || !is_own_conjugate(root(i))) continue;
      which.push_back(i);
      make_real(root(i));
      real.insert(real.end(), root(i).begin(), root(i).end());
    }
    refine(real, data_, means_);
    for (std::size_t k = 0; k < which.size(); ++k)
      make_real(std::span(real).subspan(k * size_, size_));
    const auto quality = measure(real, data_, means_);
    real_.assign(quality_.size(), false);
    for (std::size_t k = 0; k < which.size(); ++k) {
      const auto from = std::span(real).subspan(k * size_, size_);
      std::copy(from.begin(), from.end(), root(which[k]).begin());
      quality_[which[k]] = quality[k];
      real_[which[k]] = true;
    }
  }

  std::vector<RealRoot> collect() {
    std::vector<RealRoot> all;
    for (const bool real : {true, false}) {
      for (std::size_t i = 0; i < quality_.size(); ++i) {
        if (real_[i] != real) continue;
        all.push_back({RootNumbers(root(i).begin(), root(i).end()), quality_[i], real});
      }
    }
    return all;
  }

  FollowedPaths& paths_;
  const PathParameters& data_;
  const TrackingOptions& means_;
  std::size_t size_;
  std::vector<RootQuality> quality_;
  std::vector<bool> real_;
  FingerprintIndex index_;
};

}  // namespace

std::vector<RealRoot> find_real_roots(FollowedPaths& paths, const PathParameters& data,
                                      const TrackingOptions& means) {
  return Closure(paths, data, means).run();
}

}  // namespace cognate::synthesis::nine_point
