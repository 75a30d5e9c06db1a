#include "problems/chain/starts/alignment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "synthesis/chain/drawn.hpp"
#include "synthesis/chain/transform.hpp"

namespace cognate::problems {
namespace {

constexpr int kClosedStations = 32, kOpenStations = 12, kTimedStations = 24;
constexpr int kPhases = 32;
/// Lengths of the part of a drawn curve that an open target may be, as shares of the whole.
constexpr double kWindowShares[] = {0.06, 0.1, 0.15, 0.22, 0.32, 0.46, 0.64, 0.85};

/// A line through points with the length of the way along it.
struct ArcTable {
  std::vector<Vec2d> points;
  std::vector<double> arc{0};

  /// `closed`: the first point follows the last.
  template <class Points>
  ArcTable(const Points& all, bool closed) : points(all.begin(), all.end()) {
    if (closed) points.push_back(points.front());
    for (std::size_t i = 1; i < points.size(); ++i) {
      arc.push_back(arc.back() + norm(points[i] - points[i - 1]));
    }
  }

  double length() const { return arc.back(); }

  /// The place of `at` (0 … length) as a number of points from the first.
  double place(double at) const {
    const auto after = std::ranges::upper_bound(arc, at);
    const auto last = static_cast<std::ptrdiff_t>(arc.size()) - 1;
    const auto i = std::clamp<std::ptrdiff_t>(after - arc.begin() - 1, 0, last - 1);
    const double from = arc[static_cast<std::size_t>(i)],
                 step = arc[static_cast<std::size_t>(i) + 1] - from;
    return double(i) + (step > 0 ? std::clamp((at - from) / step, 0.0, 1.0) : 0);
  }

  Vec2d at_place(double place) const {
    const auto i = std::min(static_cast<std::size_t>(place), points.size() - 2);
    const double part = place - double(i);
    return (1 - part) * points[i] + part * points[i + 1];
  }
};

/// A fit of complex numbers, z ≈ move + turn·c.
struct Similarity {
  double error;
  Vec2d turn, move;
};

/// Sums that say how well `count` pairs agree.
struct Pairs {
  Vec2d sum_c, sum_z, sum_zc;
  double sum_cc = 0, sum_zz = 0;
  int count = 0;

  void add(const Vec2d& c, const Vec2d& z) {
    sum_c = sum_c + c;
    sum_z = sum_z + z;
    sum_zc = sum_zc + z * conj(c);
    sum_cc += squared_norm(c);
    sum_zz += squared_norm(z);
    ++count;
  }

  Similarity fit() const {
    const double share = 1.0 / count;
    const double own = sum_cc - share * squared_norm(sum_c);
    const Vec2d mixed = sum_zc - share * (sum_z * conj(sum_c));
    if (!(own > 0)) return {std::numeric_limits<double>::infinity(), {1, 0}, {}};
    const Vec2d turn = (1 / own) * mixed;
    const double left = sum_zz - share * squared_norm(sum_z) - squared_norm(mixed) / own;
    return {std::sqrt(std::max(left, 0.0) * share), turn, share * (sum_z - turn * sum_c)};
  }

  /// Where the curve stays where it is.
  Similarity stay() const {
    const double left = sum_zz - 2 * sum_zc.x + sum_cc;
    return {std::sqrt(std::max(left, 0.0) / count), {1, 0}, {}};
  }
};

/// The point of a drawn curve at a number of its positions, which may be beyond the turn.
Vec2d at_position(const DrawnCurve& curve, double position) {
  const double floor = std::floor(position);
  const auto index = [](double whole) {
    const int turned = static_cast<int>(std::fmod(whole, double(kDrawnPositions)));
    return static_cast<std::size_t>(turned < 0 ? turned + kDrawnPositions : turned);
  };
  const double part = position - floor;
  return (1 - part) * curve[index(floor)] + part * curve[index(floor + 1)];
}

double angle_of_place(double place) {
  return kTurn * place / kDrawnPositions;
}

std::vector<Vec2d> stations(const ArcTable& table, int count, bool closed) {
  std::vector<Vec2d> all;
  for (int i = 0; i < count; ++i) {
    all.push_back(table.at_place(table.place(table.length() * i / (closed ? count : count - 1))));
  }
  return all;
}

/// A part of a drawn curve, as the places of the target's stations along its arc.
struct Window {
  double from, length;  ///< arcs; a negative length runs backwards
  Similarity fit;
};

}  // namespace

AlignmentTarget::AlignmentTarget(const ScaledChain& problem) : problem_(problem) {
  const std::size_t points = problem.points.size();
  if (problem.timed()) {
    const auto count = std::min<std::size_t>(points, kTimedStations);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t which = i * points / count;
      stations_.push_back(problem.points[which]);
      turns_.push_back(problem.crank_angles[which]);
    }
    return;
  }
  const ArcTable table(problem.points, problem.closed);
  stations_ = stations(table, problem.closed ? kClosedStations : kOpenStations, problem.closed);
  for (std::size_t i = 0; i < points; ++i) shares_.push_back(table.arc[i] / table.length());
}

Alignment AlignmentTarget::align(const DrawnCurve& curve) const {
  return problem_.timed() ? align_timed(curve) : align_arcs(curve);
}

Alignment AlignmentTarget::align_timed(const DrawnCurve& curve) const {
  Alignment best;
  best.error = std::numeric_limits<double>::infinity();
  for (int phase = 0; phase < kPhases; ++phase) {
    const double start = kTurn * phase / kPhases;
    Pairs pairs;
    for (std::size_t i = 0; i < stations_.size(); ++i) {
      const double position = (start + turns_[i]) * kDrawnPositions / kTurn;
      pairs.add(at_position(curve, position), stations_[i]);
    }
    const Similarity fit = problem_.is_anchored() ? pairs.stay() : pairs.fit();
    if (fit.error < best.error) best = {fit.error, fit.turn, fit.move, {start}};
  }
  return best;
}

Alignment AlignmentTarget::align_arcs(const DrawnCurve& curve) const {
  const ArcTable table(curve, true);
  const bool closed = problem_.closed;
  const int count = static_cast<int>(stations_.size());
  // Points of the drawn curve at equal arcs, so many that each window's stations are among them.
  constexpr int kFine = 192;
  std::array<Vec2d, kFine> fine;
  for (int i = 0; i < kFine; ++i) {
    fine[static_cast<std::size_t>(i)] = table.at_place(table.place(table.length() * i / kFine));
  }
  Window best{0, 0, {std::numeric_limits<double>::infinity(), {1, 0}, {}}};
  const auto attempt = [&](int from, double step) {
    Pairs pairs;
    for (int i = 0; i < count; ++i) {
      const int at = from + static_cast<int>(std::lround(step * i));
      pairs.add(fine[static_cast<std::size_t>(((at % kFine) + kFine) % kFine)],
                stations_[static_cast<std::size_t>(i)]);
    }
    const Similarity fit = problem_.is_anchored() ? pairs.stay() : pairs.fit();
    if (!(fit.error < best.fit.error)) return;
    const double unit = table.length() / kFine, spans = closed ? count : count - 1;
    best = {from * unit, step * spans * unit, fit};
  };
  if (closed) {
    for (int from = 0; from < kFine; from += kFine / kClosedStations) {
      for (const int sense : {1, -1}) attempt(from, sense * double(kFine) / count);
    }
  } else {
    for (int from = 0; from < kFine; from += 6) {
      for (const double share : kWindowShares) {
        for (const int sense : {1, -1}) attempt(from, sense * share * kFine / (count - 1));
      }
    }
  }
  Alignment found{best.fit.error, best.fit.turn, best.fit.move, {}};
  for (const double share : shares_) {
    const double at = best.from + share * best.length;
    const double turns = std::floor(at / table.length());
    const double place = table.place(at - turns * table.length());
    found.angles.push_back(angle_of_place(place) + kTurn * turns);
  }
  return found;
}

synthesis::ChainDesign aligned(const ScaledChain& problem, const DrawnChain& drawn,
                               const Alignment& alignment) {
  synthesis::ChainDesign design = drawn.design;
  // What stands so with the crank at angle 0 is turned to where the crank is at this angle.
  synthesis::draw_anew(problem.lines, unit_vector(-angle_of(alignment.turn)), design);
  synthesis::transform(problem.lines, alignment.turn, alignment.move, design.parameters);
  return design;
}

}  // namespace cognate::problems
