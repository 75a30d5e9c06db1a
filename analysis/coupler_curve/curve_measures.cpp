#include "analysis/coupler_curve/curve_measures.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "analysis/linkage/mobility.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate {
namespace {

/// The greatest value of the cubic with the values f0, f1 and the derivatives d0 ≥ 0, d1 ≤ 0 at the
/// ends of [0, 1].
double cubic_peak(double f0, double d0, double f1, double d1) {
  const double a = 3 * (d0 + d1 - 2 * (f1 - f0)), b = 3 * (f1 - f0) - 2 * d0 - d1;
  // a t² + 2 b t + d0 = 0, by the form that does not cancel for a peak, where the slope falls.
  const double root = std::sqrt(std::max(b * b - a * d0, 0.0));
  const double divisor = root - b;
  const double t = divisor > 0 ? std::clamp(d0 / divisor, 0.0, 1.0) : 0;
  return f0 + t * (d0 + t * (b + t * a / 3));
}

/// Samples of a curve, looked at from directions; between samples it is a cubic.
struct Support {
  const CurveSamples& curve;
  double step = kTurn / static_cast<double>(curve.size());

  double value(std::size_t i, const Vec2d& direction) const {
    return direction.x * curve.x[i] + direction.y * curve.y[i];
  }
  double slope(std::size_t i, const Vec2d& direction) const {
    return step * (direction.x * curve.dx[i] + direction.y * curve.dy[i]);
  }

  /// How far the curve reaches next to sample i, if that is farther than its neighbours.
  double peak(std::size_t i, const Vec2d& direction) const {
    const std::size_t next = i + 1 < curve.size() ? i + 1 : 0;
    const std::size_t last = i > 0 ? i - 1 : curve.size() - 1;
    const double here = value(i, direction), rate = slope(i, direction);
    const std::size_t other = rate > 0 ? next : last;
    const double beyond = value(other, direction), back = slope(other, direction);
    if (here < beyond || rate * back >= 0) return here;
    return rate > 0 ? std::max(here, cubic_peak(here, rate, beyond, back))
                    : std::max(here, cubic_peak(beyond, back, here, rate));
  }
};

/// Takes in the arc about `centre` that `radius` along the x axis turned by `from` … `to` goes
/// through.
struct Box {
  Vec2d low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};

  void add(const Vec2d& point) {
    low = {std::min(low.x, point.x), std::min(low.y, point.y)};
    high = {std::max(high.x, point.x), std::max(high.y, point.y)};
  }
  void add_arc(const Vec2d& centre, double radius, double from, double to) {
    const auto at = [&](double angle) {
      add(centre + Vec2d{radius * std::cos(angle), radius * std::sin(angle)});
    };
    if (to - from >= kTurn) {
      add(centre - Vec2d{radius, radius});
      add(centre + Vec2d{radius, radius});
      return;
    }
    at(from);
    at(to);
    for (double k = std::ceil(from / (kRightAngle)); k * (kRightAngle) < to; ++k)
      at(k * (kRightAngle));
  }
};

/// Whether the joint C is to the left of A→D where the circuit begins; it stays there where the
/// rocker has two ranges.
bool joint_is_left(const FourBar& linkage, const CircuitChoice& circuit) {
  FourBar at_joint = linkage;
  at_joint.coupler_point = Vec2d{linkage.coupler, 0};
  CurveRoom curve;
  sample_circuit(at_joint, circuit, CycleTable(1), curve);
  const Vec2d joint = Vec2d{curve.x[0], curve.y[0]} - linkage.pivot_a;
  return cross(linkage.pivot_d - linkage.pivot_a, joint) > 0;
}

}  // namespace

void CurveSums::add_up(const CurveSamples& samples, std::size_t curves) {
  length.assign(curves, 0);
  half_length.assign(curves, 0);
  area.assign(curves, 0);
  const std::size_t rows = samples.size() / curves;
  for (std::size_t row = 0; row < rows; ++row) {
    const double *x = samples.x.data() + row * curves, *y = samples.y.data() + row * curves;
    const double *dx = samples.dx.data() + row * curves, *dy = samples.dy.data() + row * curves;
    const double half = row % 2 == 0 ? 1 : 0;
    for (std::size_t i = 0; i < curves; ++i) {
      const double speed = std::sqrt(dx[i] * dx[i] + dy[i] * dy[i]);
      length[i] += speed;
      half_length[i] += half * speed;
      // Relative to the first sample, to avoid cancellation.
      area[i] += (x[i] - samples.x[i]) * dy[i] - (y[i] - samples.y[i]) * dx[i];
    }
  }
  const double step = kTurn / static_cast<double>(rows);
  for (std::size_t i = 0; i < curves; ++i) {
    length[i] *= step;
    half_length[i] *= 2 * step;
    area[i] *= 0.5 * step;
  }
}

bool CurveSums::is_settled(std::size_t i) const {
  return std::abs(length[i] - half_length[i]) <= 1e-6 * length[i];
}

double WidthFinder::sampled_width(const CurveSamples& curve, const Vec2d& direction) {
  double low = INFINITY, high = -INFINITY;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const double value = direction.x * curve.x[i] + direction.y * curve.y[i];
    low = std::min(low, value);
    high = std::max(high, value);
  }
  return high - low;
}

CurveWidths WidthFinder::operator()(const CurveSamples& curve) {
  for (std::size_t k = 0; k < kDirections; ++k) {
    const double angle = kStep * static_cast<double>(k);
    widths_[k] = sampled_width(curve, unit_vector(angle));
  }
  const auto [least, greatest] = std::ranges::minmax(widths_);
  CurveWidths found{INFINITY, 0};
  // A width changes by no more than the diameter times the turn, and near its greatest by less.
  const double below = least + greatest * kStep, above = greatest * std::cos(kStep);
  for (std::size_t k = 0; k < kDirections; ++k) {
    const double here = widths_[k], before = widths_[(k + kDirections - 1) % kDirections],
                 after = widths_[(k + 1) % kDirections];
    const double angle = kStep * static_cast<double>(k);
    if (here <= before && here <= after && here <= below) {
      found.least = std::min(found.least, refined(curve, angle, greatest, -1));
    }
    if (here >= before && here >= after && here >= above) {
      found.greatest = std::max(found.greatest, refined(curve, angle, greatest, 1));
    }
  }
  return found;
}

/// The samples that the lines may touch, or touch next to, in directions up to a step away.
void WidthFinder::find_candidates(const CurveSamples& curve, double angle, double diameter) {
  const Support support{curve};
  const Vec2d direction = unit_vector(angle);
  double low = INFINITY, high = -INFINITY;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const double value = support.value(i, direction);
    low = std::min(low, value);
    high = std::max(high, value);
  }
  const double slack = 2 * kStep * diameter;
  low_.clear();
  high_.clear();
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const double value = support.value(i, direction);
    if (value <= low + slack) low_.push_back(i);
    if (value >= high - slack) high_.push_back(i);
  }
}

double WidthFinder::candidates_width(const CurveSamples& curve, const Vec2d& direction) const {
  const Support support{curve};
  const auto farthest = [&](const std::vector<std::size_t>& candidates, const Vec2d& towards) {
    double most = -INFINITY;
    for (const std::size_t i : candidates) {
      // Over a step the curve does not rise above what its slope at the peak's side leads to.
      const double bound = support.value(i, towards) + std::abs(support.slope(i, towards));
      if (bound > most) most = std::max(most, support.peak(i, towards));
    }
    return most;
  };
  return farthest(high_, direction) + farthest(low_, -direction);
}

double WidthFinder::refined(const CurveSamples& curve, double angle, double diameter,
                            double sense) {
  constexpr double kGolden = 0.6180339887498949;
  find_candidates(curve, angle, diameter);
  const auto score = [&](double at) { return sense * candidates_width(curve, unit_vector(at)); };
  double low = angle - kStep, high = angle + kStep;
  double a = high - kGolden * (high - low), b = low + kGolden * (high - low);
  double at_a = score(a), at_b = score(b), best = std::max(at_a, at_b);
  constexpr int kSteps = 30;
  for (int step = 0; step < kSteps; ++step) {
    if (at_b < at_a) {
      high = b;
      b = a;
      at_b = at_a;
      a = high - kGolden * (high - low);
      at_a = score(a);
    } else {
      low = a;
      a = b;
      at_a = at_b;
      b = low + kGolden * (high - low);
      at_b = score(b);
    }
    best = std::max({best, at_a, at_b});
  }
  return sense * best;
}

double moving_pivots_size(const FourBar& linkage, const CircuitChoice& circuit) {
  const Lengths<double> links = lengths(linkage);
  const double frame = frame_angle(linkage);
  Box box;
  const auto cranks = crank_ranges(links);
  const CrankRange crank = cranks.size() > 1 && circuit.half < 0 ? cranks.back() : cranks.front();
  box.add_arc(linkage.pivot_a, linkage.crank, crank.from + frame, crank.to + frame);
  // The rocker as the crank of the same linkage from its other end: angles are from D→A.
  const auto rockers = crank_ranges({links.rocker, links.coupler, links.crank, links.frame});
  const bool lower = rockers.size() > 1 && joint_is_left(linkage, circuit);
  const CrankRange rocker = lower ? rockers.back() : rockers.front();
  box.add_arc(linkage.pivot_d, linkage.rocker, rocker.from + frame + kPi, rocker.to + frame + kPi);
  return norm(box.high - box.low);
}

}  // namespace cognate
