#include "synthesis/exact/nine_point/path_parameters.hpp"

#include <algorithm>
#include <cmath>

namespace cognate::synthesis::nine_point {
namespace {

LinearPair line(const Number& from, const Number& to) {
  return {pair(to), pair(from - to)};
}

Number at(const LinearPair& line, double r) {
  return number(line.at_end) + r * number(line.slope);
}

}  // namespace

PathParameters parameters_of(const PathSystem& system) {
  PathParameters data{system.kind, system.d, system.d, system.t};
  for (Number& d : data.d_bar) d = std::conj(d);
  return data;
}

ParameterLine parameter_line(const PathParameters& from, const PathParameters& to) {
  ParameterLine lines;
  for (std::size_t j = 0; j < to.d.size(); ++j) {
    lines.d[j] = line(from.d[j], to.d[j]);
    lines.d_bar[j] = line(from.d_bar[j], to.d_bar[j]);
  }
  for (std::size_t j = 0; j < to.t.size(); ++j) {
    const Number half_way = from.t[j] * std::sqrt(to.t[j] / from.t[j]);
    lines.turn_above[j] = line(from.t[j], half_way);
    lines.turn_below[j] = line(1.0, half_way / to.t[j]);
  }
  return lines;
}

PathParameters parameters_at(const ParameterLine& line, double r, const PathClass& kind) {
  PathParameters data{kind, {}, {}, {}};
  const int poses = kind.poses - 1;
  for (int j = 0; j < poses + kind.points; ++j) {
    data.d.push_back(at(line.d[j], r));
    data.d_bar.push_back(at(line.d_bar[j], r));
    if (j < poses) data.t.push_back(at(line.turn_above[j], r) / at(line.turn_below[j], r));
  }
  return data;
}

Fingerprint fingerprint(const PathClass& kind, std::span<const Pair> root) {
  const auto combine = [&](int bar, double& size) {
    const Number x = number(root[0 + bar]), a = number(root[2 + bar]);
    const Number y = number(root[4 + bar]), b = number(root[6 + bar]);
    if (kind.poses > 1) {
      const Number generic(0.61, bar == 0 ? 0.47 : -0.53);
      size += std::abs(x) + std::abs(a) + std::abs(y) + std::abs(b);
      return a + b + generic * (x + y);
    }
    const Number bx = b * x, ay = a * y, between = x - y;
    size += std::abs(a) + std::abs(b) + (std::abs(bx) + std::abs(ay)) / std::abs(between);
    return a + b + (bx - ay) / between;
  };
  Fingerprint print;
  print.plain = combine(0, print.size);
  print.barred = combine(1, print.size);
  return print;
}

bool same(const Fingerprint& a, const Fingerprint& b, double tolerance) {
  const double near = tolerance * (1 + std::max(a.size, b.size));
  return std::abs(a.plain - b.plain) <= near && std::abs(a.barred - b.barred) <= near;
}

int FingerprintIndex::find(const Fingerprint& print, double tolerance) const {
  // Twice its own size covers the size of every other that can be the same.
  const double near = 2 * tolerance * (1 + print.size);
  auto at =
      std::lower_bound(sorted_.begin(), sorted_.end(), std::pair(print.plain.real() - near, -1));
  for (; at != sorted_.end() && at->first <= print.plain.real() + near; ++at) {
    if (same(prints_[at->second], print, tolerance)) return at->second;
  }
  return -1;
}

void FingerprintIndex::add(const Fingerprint& print) {
  const std::pair entry(print.plain.real(), static_cast<int>(prints_.size()));
  sorted_.insert(std::upper_bound(sorted_.begin(), sorted_.end(), entry), entry);
  prints_.push_back(print);
}

RootNumbers next_cognate(const PathParameters& data, std::span<const Pair> root) {
  RootNumbers next(root.begin(), root.end());
  for (int bar = 0; bar < 2; ++bar) {
    const Number x = number(root[0 + bar]), a = number(root[2 + bar]);
    const Number y = number(root[4 + bar]), b = number(root[6 + bar]);
    const Number scale = 1.0 / (x - y);
    next[0 + bar] = pair((x - a) * y * scale);
    next[2 + bar] = pair((b * x - a * y) * scale);
    next[4 + bar] = pair(a - x);
    next[6 + bar] = pair(a);
  }
  const Number x = number(root[0]), a = number(root[2]);
  for (std::size_t j = 0; j < data.d.size(); ++j) {
    next[kPivots + j] = pair((x * number(root[kPivots + j]) + data.d[j] - a) / (x - a));
  }
  return next;
}

}  // namespace cognate::synthesis::nine_point
