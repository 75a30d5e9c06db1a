/// @file What is known of the path in each lane, and one step along all of them. Include in the
/// kernel alone.
#pragma once

#include "synthesis/exact/nine_point/taylor.hpp"

namespace cognate::synthesis::nine_point::COGNATE_ISA {

/// A straight line in each lane.
struct LinearComplex {
  Complex at_end, slope;

  Complex at(const Real& r) const { return {at_end.re + r * slope.re, at_end.im + r * slope.im}; }
};

/// What a step came to, in each lane.
struct StepSizes {
  double first[kLanes];     ///< Newton's first correction, relative
  double second[kLanes];    ///< and its second
  double highest[kLanes];   ///< the last coefficient of the Taylor series, relative
  double greatest[kLanes];  ///< the largest pivot
};

/// The paths of all lanes: where they are and how they go on.
class LaneState {
 public:
  explicit LaneState(int points) : equations_(points) {
    // Lanes without a path follow one of harmless numbers, whose result is not looked at.
    const Complex one{Real(1.0), Real(0.5)};
    for (Complex& z : here_.pivot) z = one;
    for (Complex& t : here_.turn) t = one;
    for (LinearComplex& line : d_) line = {one, one};
    for (LinearComplex& line : d_bar_) line = {one, one};
    for (LinearComplex& line : above_) line = {one, one};
    for (LinearComplex& line : below_) line = {one, one};
    for (auto& order : pivot_) {
      for (Complex& z : order) z = {Real(0.0), Real(0.0)};
    }
    for (auto& order : turn_) {
      for (Complex& t : order) t = {Real(0.0), Real(0.0)};
    }
  }

  /// Puts a path into a lane, with unknowns as in TrackTask.
  void put(int lane, const Pair* start, const ParameterLine& line) {
    for (int i = 0; i < kPivots; ++i) set(here_.pivot[i], lane, start[i]);
    for (int j = 0; j < equations_.points(); ++j) set(here_.turn[j], lane, start[kPivots + j]);
    for (int j = 0; j < equations_.positions(); ++j) {
      set(d_[j], lane, line.d[j]);
      set(d_bar_[j], lane, line.d_bar[j]);
    }
    for (int j = 0; j < equations_.poses(); ++j) {
      set(above_[j], lane, line.turn_above[j]);
      set(below_[j], lane, line.turn_below[j]);
    }
    for (auto& order : pivot_) {
      for (Complex& z : order) set(z, lane, Pair{});
    }
    for (auto& order : turn_) {
      for (Complex& t : order) set(t, lane, Pair{});
    }
  }

  void get(int lane, Pair* to) const {
    for (int i = 0; i < kPivots; ++i) to[i] = lane_of(here_.pivot[i], lane);
    for (int j = 0; j < equations_.points(); ++j) {
      to[kPivots + j] = lane_of(here_.turn[j], lane);
    }
  }

  /// Predicts where the paths are after steps that lead to `r`, and corrects by Newton's method:
  /// twice. (The series is found by the Jacobian of the second time: that of the first, some 1e-3
  /// away, spoils it where the roots are badly conditioned.)
  void attempt(const double (&step)[kLanes], const double (&r)[kLanes], StepSizes& sizes) {
    predict(load(step));
    r_ = load(r);
    find_parameters();
    weigh();
    equations_.evaluate(next_, parameters_);
    equations_.factor();
    correct(sizes.first);
    equations_.evaluate(next_, parameters_);
    equations_.factor();
    correct(sizes.second);
  }

  /// Keeps what was attempted in lanes where `accepted` is 1, and finds the series there.
  void go_on(const double (&accepted)[kLanes], StepSizes& sizes) {
    const Mask keep = load(accepted) > Real(0.5);
    series_.expand(equations_, next_, series_of_parameters());
    Real highest(0.0), greatest(0.0);
    for (int i = 0; i < kPivots; ++i) {
      here_.pivot[i] = choose(keep, next_.pivot[i], here_.pivot[i]);
      for (int k = 1; k <= kOrder; ++k) {
        pivot_[k - 1][i] = choose(keep, series_.pivot[k][i], pivot_[k - 1][i]);
      }
      highest = larger(highest, weight_[i] * size(pivot_[kOrder - 1][i]));
      greatest = larger(greatest, size(here_.pivot[i]));
    }
    for (int j = 0; j < equations_.points(); ++j) {
      here_.turn[j] = choose(keep, next_.turn[j], here_.turn[j]);
      for (int k = 1; k <= kOrder; ++k) {
        turn_[k - 1][j] = choose(keep, series_.turn[k][j], turn_[k - 1][j]);
      }
      const Real inverse_size = size(equations_.position(equations_.poses() + j).inverse_turn);
      highest = larger(highest, inverse_size * size(turn_[kOrder - 1][j]));
    }
    store(highest, sizes.highest);
    store(greatest, sizes.greatest);
  }

 private:
  void set(Complex& z, int lane, const Pair& to) {
    set_lane(z.re, lane, to.re);
    set_lane(z.im, lane, to.im);
  }
  void set(LinearComplex& line, int lane, const LinearPair& to) {
    set(line.at_end, lane, to.at_end);
    set(line.slope, lane, to.slope);
  }
  static Pair lane_of(const Complex& z, int lane) {
    double re[kLanes], im[kLanes];
    store(z.re, re);
    store(z.im, im);
    return {re[lane], im[lane]};
  }

  static Complex at_step(const Complex& from, const Complex* coefficients, int stride,
                         const Real& step) {
    Complex sum = coefficients[(kOrder - 1) * stride];
    for (int k = kOrder - 2; k >= 0; --k) sum = coefficients[k * stride] + step * sum;
    return from + step * sum;
  }

  void predict(const Real& step) {
    for (int i = 0; i < kPivots; ++i) {
      next_.pivot[i] = at_step(here_.pivot[i], &pivot_[0][i], kPivots, step);
    }
    for (int j = 0; j < equations_.points(); ++j) {
      next_.turn[j] = at_step(here_.turn[j], &turn_[0][j], kPositions, step);
    }
  }

  void find_parameters() {
    for (int j = 0; j < equations_.positions(); ++j) {
      parameters_.d[j] = d_[j].at(r_);
      parameters_.d_bar[j] = d_bar_[j].at(r_);
    }
    for (int j = 0; j < equations_.poses(); ++j) {
      const Complex above = above_[j].at(r_), below = below_[j].at(r_);
      parameters_.turn[j] = above * inverse(below);
      parameters_.inverse_turn[j] = below * inverse(above);
    }
  }

  /// The coefficients of a quotient of two lines in −Δr.
  static void expand_quotient(const LinearComplex& above, const LinearComplex& below, const Real& r,
                              Complex (&series)[kOrder + 1]) {
    const Complex factor = inverse(below.at(r));
    const Complex slope = below.slope * factor;
    series[0] = above.at(r) * factor;
    series[1] = series[0] * slope - above.slope * factor;
    for (int k = 2; k <= kOrder; ++k) series[k] = slope * series[k - 1];
  }

  const ParameterSeries& series_of_parameters() {
    for (int j = 0; j < equations_.positions(); ++j) {
      parameter_series_.d[j] = -d_[j].slope;
      parameter_series_.d_bar[j] = -d_bar_[j].slope;
    }
    for (int j = 0; j < equations_.poses(); ++j) {
      expand_quotient(above_[j], below_[j], r_, parameter_series_.turn[j]);
      expand_quotient(below_[j], above_[j], r_, parameter_series_.inverse_turn[j]);
    }
    return parameter_series_;
  }

  void weigh() {
    for (int i = 0; i < kPivots; ++i) {
      weight_[i] = Real(1.0) / (Real(1.0) + size(next_.pivot[i]));
    }
  }

  /// One Newton step of the attempt; its relative size is NaN where it is unknown.
  void correct(double (&sizes)[kLanes]) {
    Unknowns change;
    equations_.newton(change);
    Real sum(0.0);
    for (int i = 0; i < kPivots; ++i) {
      next_.pivot[i] = next_.pivot[i] + change.pivot[i];
      sum = sum + weight_[i] * size(change.pivot[i]);
    }
    for (int j = 0; j < equations_.points(); ++j) {
      next_.turn[j] = add_product(next_.turn[j], next_.turn[j], change.turn[j]);
      sum = sum + size(change.turn[j]);
    }
    store(sum, sizes);
  }

  LaneEquations equations_;
  LinearComplex d_[kPositions], d_bar_[kPositions], above_[kPoses], below_[kPoses];
  Unknowns here_, next_;
  Complex pivot_[kOrder][kPivots], turn_[kOrder][kPositions];
  Real r_, weight_[kPivots];
  Parameters parameters_;
  ParameterSeries parameter_series_;
  Series series_;
};

}  // namespace cognate::synthesis::nine_point::COGNATE_ISA
