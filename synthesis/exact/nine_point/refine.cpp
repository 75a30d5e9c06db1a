#include "synthesis/exact/nine_point/refine.hpp"

#include <algorithm>
#include <cmath>

#include "synthesis/exact/nine_point/path_equations.hpp"
#include "synthesis/exact/nine_point/position_miss.hpp"

namespace cognate::synthesis::nine_point {
namespace {

/// Of a root with a smaller condition, residuals of doubles find all digits but the last few.
constexpr double kWellConditioned = 1e3;
/// Corrections that are no more than rounding of the unknowns themselves.
constexpr double kRounding = 1e-15;
constexpr int kMostRounds = 5;

/// The change relative to 1 + |pivot|, of rotations relative to them.
double relative_size(std::span<const Pair> root, std::span<const Pair> change) {
  double size = 0;
  for (std::size_t i = 0; i < root.size(); ++i) {
    const double scale = i < kPivots ? 1 + std::abs(number(root[i])) : 1;
    size = larger(size, std::abs(number(change[i])) / scale);
  }
  return size;
}

void apply(std::span<Pair> root, std::span<const Pair> change) {
  for (std::size_t i = 0; i < root.size(); ++i) {
    const Number z = number(root[i]), by = number(change[i]);
    root[i] = pair(i < kPivots ? z + by : z + z * by);
  }
}

Dyad<Number> dyad(std::span<const Pair> root, int e) {
  const auto z = root.subspan(e == 0 ? 0 : 4, 4);
  return {number(z[0]), number(z[1]), number(z[2]), number(z[3])};
}

/// What an inspection says of its root number k.
RootQuality quality_of(const Inspection& seen, std::size_t k, std::span<const Pair> root,
                       const PathParameters& data) {
  constexpr std::size_t kValues = 2 * std::size_t{kPositions};
  return {seen.conditions[k],
          relative_size(root, std::span(seen.changes).subspan(k * root.size(), root.size())),
          position_error(root, data, std::span(seen.values).subspan(k * kValues, kValues))};
}

}  // namespace

double position_error(std::span<const Pair> root, const PathParameters& data,
                      std::span<const Pair> values) {
  const std::size_t poses = data.t.size();
  double worst = 0;
  for (std::size_t j = 0; j < data.d.size(); ++j) {
    const Number t = j < poses ? data.t[j] : number(root[kPivots + j - poses]);
    const CouplerMove<Number> to{t, 1.0 / t, data.d[j], data.d_bar[j]};
    const auto f = dyad_equation(dyad(root, 0), to), g = dyad_equation(dyad(root, 1), to);
    const Number f_value = number(values[2 * j]), g_value = number(values[2 * j + 1]);
    worst = larger(worst, position_miss(f, g, f_value, g_value, j < poses));
  }
  return worst;
}

std::vector<RootQuality> measure(std::span<const Pair> roots, const PathParameters& data,
                                 const TrackingOptions& means) {
  const std::size_t size = unknowns(data.kind.points);
  const Inspection seen = inspect(roots, data.kind.points, parameter_line(data, data), true, means);
  std::vector<RootQuality> quality(seen.conditions.size());
  for (std::size_t k = 0; k < quality.size(); ++k) {
    quality[k] = quality_of(seen, k, roots.subspan(k * size, size), data);
  }
  return quality;
}

std::vector<RootQuality> refine(std::span<Pair> roots, const PathParameters& data,
                                const TrackingOptions& means) {
  const int points = data.kind.points;
  const std::size_t size = unknowns(points), count = roots.size() / size;
  const ParameterLine line = parameter_line(data, data);
  std::vector<RootQuality> quality(count);
  std::vector<int> left(count);
  for (std::size_t i = 0; i < count; ++i) left[i] = static_cast<int>(i);

  for (int round = 0; round < kMostRounds && !left.empty(); ++round) {
    std::vector<Pair> some;
    some.reserve(left.size() * size);
    for (const int i : left) {
      some.insert(some.end(), roots.begin() + i * size, roots.begin() + (i + 1) * size);
    }
    const Inspection seen = inspect(some, points, line, round > 0, means);
    std::vector<int> next;
    for (std::size_t k = 0; k < left.size(); ++k) {
      const auto root = roots.subspan(left[k] * size, size);
      RootQuality& one = quality[left[k]];
      const double before = one.correction;
      one = quality_of(seen, k, root, data);
      const bool first = round == 0;
      if (first && one.condition < kWellConditioned) continue;
      // The first residual has the rounding errors of doubles: it is not to be followed.
      if (first) {
        next.push_back(left[k]);
      } else if (one.correction > kRounding && one.correction < 0.5 * before &&
                 round + 1 < kMostRounds) {
        apply(root, std::span(seen.changes).subspan(k * size, size));
        next.push_back(left[k]);
      }
    }
    left = std::move(next);
  }
  return quality;
}

}  // namespace cognate::synthesis::nine_point
