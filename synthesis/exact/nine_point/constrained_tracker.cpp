#include "synthesis/exact/nine_point/constrained_tracker.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "synthesis/exact/nine_point/position_miss.hpp"

namespace cognate::synthesis::constrained {
namespace {

/// A change of a state: of the pivots, and of the logarithms of the rotations.
template <class Real>
struct Change {
  Eigen::Matrix<std::complex<Real>, kPivotUnknowns, 1> pivots;
  std::vector<std::complex<Real>> log_t;
};

template <class Real>
StateOf<Real> moved(const StateOf<Real>& state, const Change<Real>& change, Real by) {
  StateOf<Real> result = state;
  for (int i = 0; i < kPivotUnknowns; ++i) result.pivots[std::size_t(i)] += by * change.pivots[i];
  for (std::size_t j = 0; j < result.log_t.size(); ++j) result.log_t[j] += by * change.log_t[j];
  return result;
}

/// The largest change relative to 1 + |unknown|; not a number where one is not.
template <class Real>
double size(const Change<Real>& change, const StateOf<Real>& at) {
  double largest = 0;
  const auto take = [&](Real value) { largest = larger(largest, double(value)); };
  for (int i = 0; i < kPivotUnknowns; ++i) {
    take(std::abs(change.pivots[i]) / (1 + std::abs(at.pivots[std::size_t(i)])));
  }
  for (const auto& z : change.log_t) take(std::abs(z));
  return largest;
}

template <class Real>
double largest_pivot(const StateOf<Real>& state) {
  double largest = 0;
  for (const auto& z : state.pivots) largest = std::max(largest, double(std::abs(z)));
  return largest;
}

/// The linearised equations at a state. Each rotation that is free occurs in two of them, q times
/// the first less p times the second has it no more (p = t ∂f/∂t, q = t ∂g/∂t): eight are left.
template <class Real>
class Linearised {
  using Complex = std::complex<Real>;
  using Vector = Eigen::Matrix<Complex, kPivotUnknowns, 1>;
  using Matrix = Eigen::Matrix<Complex, kPivotUnknowns, kPivotUnknowns>;
  using State = StateOf<Real>;
  using Data = DataOf<Real>;

 public:
  Linearised(const State& state, const Data& data) : state_(state), data_(data) {
    const Dyad<Complex> first{state.pivots[0], state.pivots[1], state.pivots[2], state.pivots[3]};
    const Dyad<Complex> second{state.pivots[4], state.pivots[5], state.pivots[6], state.pivots[7]};
    Matrix rows = Matrix::Zero();
    int row = 0;
    for (std::size_t j = 0; j < data.d.size(); ++j) {
      const Complex t = rotation(j);
      const CouplerMove<Complex> to{t, Real(1) / t, data.d[j], data.d_bar[j]};
      f_.push_back(dyad_equation(first, to));
      g_.push_back(dyad_equation(second, to));
      const auto put = [&](const DyadEquation<Complex>& e, int column, Complex factor) {
        rows.row(row).template segment<4>(column) << factor * e.moving, factor * e.moving_bar,
            factor * e.fixed, factor * e.fixed_bar;
      };
      if (is_given(j)) {
        put(f_[j], 0, 1);
        ++row;
        put(g_[j], 4, 1);
      } else {
        put(f_[j], 0, g_[j].log_t);
        put(g_[j], 4, -f_[j].log_t);
      }
      ++row;
    }
    for (const SideConditionOf<Real>& condition : data.conditions) {
      const auto gradient = side_gradient(condition, state.pivots);
      for (int i = 0; i < kPivotUnknowns; ++i) rows(row, i) = gradient[std::size_t(i)];
      ++row;
    }
    for (int i = 0; i < kPivotUnknowns; ++i) {
      const Real largest = rows.row(i).cwiseAbs().maxCoeff();
      scale_[i] = largest > 0 ? 1 / largest : 1;
      rows.row(i) *= scale_[i];
    }
    lu_.compute(rows);
  }

  int rank() const {
    constexpr double kZero = 1e-9;  // rows have largest entries of 1
    Eigen::FullPivLU<Matrix> lu;
    lu.setThreshold(kZero);
    return int(lu.compute(lu_.reconstructedMatrix()).rank());
  }

  /// Solves for the change that takes `f`, `g` of each position and `h` of each condition away.
  template <class F, class G, class H>
  Change<Real> solve(F&& f, G&& g, H&& h) const {
    Vector right;
    int row = 0;
    for (std::size_t j = 0; j < data_.d.size(); ++j) {
      if (is_given(j)) {
        right[row++] = -f(j);
        right[row++] = -g(j);
      } else {
        right[row++] = f_[j].log_t * g(j) - g_[j].log_t * f(j);
      }
    }
    for (std::size_t i = 0; i < data_.conditions.size(); ++i) right[row++] = -h(i);
    for (int i = 0; i < kPivotUnknowns; ++i) right[i] *= scale_[i];
    Change<Real> change{lu_.solve(right), {}};
    for (std::size_t j = data_.t.size(); j < data_.d.size(); ++j) {
      const Complex rest_f = -f(j) - along(f_[j], change.pivots, 0);
      const Complex rest_g = -g(j) - along(g_[j], change.pivots, 4);
      const Complex p = f_[j].log_t, q = g_[j].log_t;
      change.log_t.push_back((std::conj(p) * rest_f + std::conj(q) * rest_g) /
                             (std::norm(p) + std::norm(q)));
    }
    return change;
  }

  /// Newton's step.
  Change<Real> correction() const {
    return solve([&](std::size_t j) { return f_[j].value; },
                 [&](std::size_t j) { return g_[j].value; },
                 [&](std::size_t i) { return side_value(data_.conditions[i], state_.pivots); });
  }

  /// The derivative of the solution where the data change by `rate`.
  Change<Real> tangent(const Data& rate) const {
    const auto by = [&](const DyadEquation<Complex>& e, std::size_t j) {
      const Complex turn = is_given(j) ? e.log_t * rate.t[j] / data_.t[j] : Complex(0);
      return e.d * rate.d[j] + e.d_bar * rate.d_bar[j] + turn;
    };
    return solve([&](std::size_t j) { return by(f_[j], j); },
                 [&](std::size_t j) { return by(g_[j], j); },
                 [&](std::size_t i) { return linear_rate(rate.conditions[i]); });
  }

  Quality quality() const {
    Quality known;
    const auto none = [](std::size_t) { return Complex(0); };
    for (std::size_t j = 0; j < data_.d.size(); ++j) {
      for (const auto partial : {&DyadEquation<Complex>::d, &DyadEquation<Complex>::d_bar}) {
        const auto only = [&, partial](const std::vector<DyadEquation<Complex>>& all) {
          return
              [&all, partial, j](std::size_t k) { return k == j ? all[k].*partial : Complex(0); };
        };
        known.condition += solve(only(f_), only(g_), none).pivots.squaredNorm();
      }
      known.residual = larger(known.residual,
                              position_miss(f_[j], g_[j], f_[j].value, g_[j].value, is_given(j)));
    }
    known.condition = std::sqrt(known.condition);
    return known;
  }

 private:
  bool is_given(std::size_t j) const { return j < data_.t.size(); }
  Complex rotation(std::size_t j) const {
    return is_given(j) ? data_.t[j] : std::exp(state_.log_t[j - data_.t.size()]);
  }
  static Complex along(const DyadEquation<Complex>& e, const Vector& pivots, int from) {
    return e.moving * pivots[from] + e.moving_bar * pivots[from + 1] + e.fixed * pivots[from + 2] +
           e.fixed_bar * pivots[from + 3];
  }
  Complex linear_rate(const SideConditionOf<Real>& rate) const {
    Complex sum = -rate.value;
    for (std::size_t i = 0; i < rate.linear.size(); ++i) {
      sum += rate.linear[i] * state_.pivots[i];
    }
    return sum;
  }

  const State& state_;
  const Data& data_;
  std::vector<DyadEquation<Complex>> f_, g_;
  Eigen::Array<Real, kPivotUnknowns, 1> scale_;
  Eigen::PartialPivLU<Matrix> lu_;
};

/// What the data change by from s = 0 to 1.
template <class Real>
DataOf<Real> rate_between(const DataOf<Real>& from, const DataOf<Real>& to) {
  DataOf<Real> rate = to;
  const auto subtract = [](auto& a, const auto& b) {
    for (std::size_t j = 0; j < a.size(); ++j) a[j] -= b[j];
  };
  subtract(rate.d, from.d);
  subtract(rate.d_bar, from.d_bar);
  subtract(rate.t, from.t);
  for (std::size_t i = 0; i < rate.conditions.size(); ++i) {
    subtract(rate.conditions[i].linear, from.conditions[i].linear);
    rate.conditions[i].value -= from.conditions[i].value;
  }
  return rate;
}

/// The data where `rest` of the way to `to` is left.
template <class Real>
DataOf<Real> data_at(const DataOf<Real>& to, const DataOf<Real>& rate, Real rest) {
  DataOf<Real> data = to;
  const auto go_back = [rest](auto& a, const auto& by) {
    for (std::size_t j = 0; j < a.size(); ++j) a[j] -= rest * by[j];
  };
  go_back(data.d, rate.d);
  go_back(data.d_bar, rate.d_bar);
  go_back(data.t, rate.t);
  for (std::size_t i = 0; i < data.conditions.size(); ++i) {
    go_back(data.conditions[i].linear, rate.conditions[i].linear);
    data.conditions[i].value -= rest * rate.conditions[i].value;
  }
  return data;
}

/// Runge and Kutta's prediction from `rest` to `rest` − h.
template <class Real>
StateOf<Real> predicted(const StateOf<Real>& at, const DataOf<Real>& to, const DataOf<Real>& rate,
                        Real rest, Real h) {
  const auto slope = [&](const StateOf<Real>& state, Real where) {
    const DataOf<Real> data = data_at(to, rate, where);
    return Linearised<Real>(state, data).tangent(rate);
  };
  const Change<Real> k1 = slope(at, rest);
  const Change<Real> k2 = slope(moved(at, k1, h / 2), rest - h / 2);
  const Change<Real> k3 = slope(moved(at, k2, h / 2), rest - h / 2);
  const Change<Real> k4 = slope(moved(at, k3, h), rest - h);
  StateOf<Real> result = moved(at, k1, h / 6);
  result = moved(result, k2, h / 3);
  result = moved(result, k3, h / 3);
  return moved(result, k4, h / 6);
}

template <class Real>
bool settle(StateOf<Real>& state, const DataOf<Real>& data) {
  constexpr double kSettled = 1e-14, kAccepted = 1e-6;
  double last = 1;
  for (int i = 0; i < 12; ++i) {
    const Change<Real> change = Linearised<Real>(state, data).correction();
    const double length = size(change, state);
    if (!(length < 1e3)) return false;
    if (i > 2 && length >= last) break;
    state = moved(state, change, Real(1));
    last = length;
    if (length <= kSettled) break;
  }
  return last <= kAccepted;
}

/// Where a path has arrived.
template <class Real>
struct Place {
  PathEnd end = PathEnd::lost;
  StateOf<Real> state;
};

template <class Real>
Place<Real> followed(const StateOf<Real>& start, const DataOf<Real>& from, const DataOf<Real>& to,
                     const TrackingTolerances& care) {
  constexpr double kLeastStep = 1e-11, kFar = 1e8, kSecond = 1e-7;
  constexpr double kNearEnd = 1e-3;
  constexpr double kLeastPole = 0.2;  // pivots grow as rest^(−1/k), k small
  constexpr int kMostSteps = 4000;
  const DataOf<Real> rate = rate_between(from, to);
  Place<Real> path{PathEnd::lost, start};
  Real rest = 1, h = Real(0.02);
  double size_near_end = 0;
  for (int step = 0; step < kMostSteps && rest > 0; ++step) {
    h = std::min({h, Real(care.largest_step), rest});
    StateOf<Real> trial = predicted(path.state, to, rate, rest, h);
    const DataOf<Real> data = data_at(to, rate, rest - h);
    const Change<Real> first = Linearised<Real>(trial, data).correction();
    const double first_size = size(first, trial);
    bool accepted = first_size <= care.first_correction;
    if (accepted) {
      trial = moved(trial, first, Real(1));
      const Change<Real> second = Linearised<Real>(trial, data).correction();
      accepted = size(second, trial) <= std::max(kSecond, 0.1 * first_size * first_size);
      trial = moved(trial, second, Real(1));
    }
    if (accepted) {
      path.state = std::move(trial);
      rest -= h;
      if (rest > kNearEnd) size_near_end = largest_pivot(path.state);
      if (first_size < 0.02 * care.first_correction) h *= 2;
      if (largest_pivot(path.state) > kFar) break;
    } else {
      h /= 2;
      if (h < kLeastStep * std::min(Real(1), rest / Real(kNearEnd))) break;
    }
  }
  if (rest <= 0 && settle(path.state, to)) {
    path.end = PathEnd::finite;
  } else if (const double largest = largest_pivot(path.state); largest > kFar) {
    path.end = PathEnd::infinite;
  } else if (rest > 0 && rest < kNearEnd) {
    const double grown = largest / std::max(1.0, size_near_end);
    const bool is_pole = grown > std::pow(kNearEnd / double(rest), kLeastPole);
    if (is_pole) path.end = PathEnd::infinite;
  }
  return path;
}

template <class To, class From>
std::vector<std::complex<To>> converted(const std::vector<std::complex<From>>& all) {
  std::vector<std::complex<To>> result;
  for (const auto& z : all) result.emplace_back(To(z.real()), To(z.imag()));
  return result;
}

template <class To, class From>
StateOf<To> converted(const StateOf<From>& state) {
  StateOf<To> result;
  for (std::size_t i = 0; i < state.pivots.size(); ++i) {
    result.pivots[i] = {To(state.pivots[i].real()), To(state.pivots[i].imag())};
  }
  result.log_t = converted<To>(state.log_t);
  return result;
}

DataOf<long double> extended(const Data& data) {
  DataOf<long double> result{converted<long double>(data.d),
                             converted<long double>(data.d_bar),
                             converted<long double>(data.t),
                             {}};
  for (const SideCondition& condition : data.conditions) {
    SideConditionOf<long double> one{{}, condition.value, condition.from, condition.to};
    std::ranges::copy(condition.linear, one.linear.begin());
    result.conditions.push_back(one);
  }
  return result;
}

}  // namespace

bool converge(State& state, const Data& data) {
  return settle(state, data);
}

TrackedPath follow(const State& start, const Data& from, const Data& to,
                   const TrackingTolerances& care) {
  if (!care.extended) {
    Place<double> path = followed(start, from, to, care);
    return {path.end, std::move(path.state)};
  }
  const auto path = followed(converted<long double>(start), extended(from), extended(to), care);
  return {path.end, converted<double>(path.state)};
}

Quality quality(const State& state, const Data& data) {
  return Linearised<double>(state, data).quality();
}

int rank(const State& state, const Data& data) {
  return Linearised<double>(state, data).rank();
}

}  // namespace cognate::synthesis::constrained
