/// @file A limit on the four link lengths as data, and its value in any number type.
///
/// Plain templates without the standard library, so that they may be compiled for each instruction
/// set apart.
#pragma once

namespace cognate::synthesis {

/// A smooth function of the lengths that is to be ≥ 0. Lengths and weights are in the order crank,
/// coupler, rocker, frame.
struct LinkLimit {
  enum class Kind {
    linear,            ///< weights · lengths − margin
    grashof_excess,    ///< weights[0] · (shortest + longest − the other two)
    transmission_min,  ///< limit_cosine − cos μ with the crank along the frame, towards D
    transmission_max,  ///< cos μ − limit_cosine with the crank along the frame, away from D
    /// limit_cosine − cos δ and cos δ − limit_cosine, δ being the angle by which the crank turns
    /// more than half a turn from one limit of a crank-rocker to the other: K = (π + δ)/(π − δ).
    time_ratio_min,
    time_ratio_max
  };
  Kind kind = Kind::linear;
  double weights[4] = {};
  double limit_cosine = 0;
  double margin = 0;
};

/// A function of the lengths and its derivatives by them.
template <class T>
struct LinkFunction {
  T value{};
  T slope[4] = {};
};

/// cos μ where the diagonal B–D is |l₄ + turn·l₁|.
template <class T>
LinkFunction<T> transmission_cosine(const T* l, double turn) {
  const T diagonal = l[3] + T(turn) * l[0];
  const T inverse = T(1.0) / (l[1] * l[2]);
  const T cosine = T(0.5) * inverse * (l[1] * l[1] + l[2] * l[2] - diagonal * diagonal);
  const T by_frame = -(diagonal * inverse);
  return {cosine,
          {T(turn) * by_frame, inverse * (l[1] - cosine * l[2]), inverse * (l[2] - cosine * l[1]),
           by_frame}};
}

/// cos δ: δ is the difference of the angles at A of the triangles with sides l₂ ± l₁, l₄ and l₃,
/// which the linkage forms where coupler and crank are in line. Triangles that do not close count
/// as flat, and a coupler shorter than the crank as hardly longer.
template <class T, class Operations>
LinkFunction<T> imbalance_cosine(const T* l, const Operations& with) {
  T cosine[2], sine[2], by_side[2], by_rocker[2], by_frame[2];
  for (int i = 0; i < 2; ++i) {
    const T side = i == 0 ? l[1] + l[0] : with.larger(l[1] - l[0], T(1e-6) * l[3]);
    const T inverse = T(1.0) / (side * l[3]);
    const T raw = T(0.5) * inverse * (side * side + l[3] * l[3] - l[2] * l[2]);
    cosine[i] = with.larger(T(-1.0), with.smaller(T(1.0), raw));
    sine[i] = with.larger(T(1e-6), with.root(T(1.0) - cosine[i] * cosine[i]));
    // Of the angle: −1/sine times those of its cosine.
    const T factor = T(-1.0) / sine[i];
    by_side[i] = factor * inverse * (side - raw * l[3]);
    by_frame[i] = factor * inverse * (l[3] - raw * side);
    by_rocker[i] = -(factor * inverse * l[2]);
  }
  const T sine_of_difference = sine[1] * cosine[0] - cosine[1] * sine[0];
  const T down = -sine_of_difference;
  return {cosine[0] * cosine[1] + sine[0] * sine[1],
          {down * (-by_side[1] - by_side[0]), down * (by_side[1] - by_side[0]),
           down * (by_rocker[1] - by_rocker[0]), down * (by_frame[1] - by_frame[0])}};
}

/// `limit` at the four lengths `l`. `with` has larger(a, b), smaller(a, b), root(a) and is_equal(a,
/// b), which is one or zero.
template <class T, class Operations>
LinkFunction<T> evaluate(const LinkLimit& limit, const T* l, const Operations& with) {
  using Kind = LinkLimit::Kind;
  LinkFunction<T> at;
  T sign(1.0);
  switch (limit.kind) {
    case Kind::linear:
      at.value = T(-limit.margin);
      for (int k = 0; k < 4; ++k) {
        at.slope[k] = T(limit.weights[k]);
        at.value = at.value + at.slope[k] * l[k];
      }
      return at;
    case Kind::grashof_excess: {
      const T longest = with.larger(with.larger(l[0], l[1]), with.larger(l[2], l[3]));
      const T shortest = with.smaller(with.smaller(l[0], l[1]), with.smaller(l[2], l[3]));
      at.value =
          T(limit.weights[0]) * (T(2.0) * (longest + shortest) - (l[0] + l[1] + l[2] + l[3])) -
          T(limit.margin);
      for (int k = 0; k < 4; ++k) {
        const T extreme = with.is_equal(l[k], longest) + with.is_equal(l[k], shortest);
        at.slope[k] = T(limit.weights[0]) * (T(2.0) * extreme - T(1.0));
      }
      return at;
    }
    case Kind::transmission_min:
      sign = T(-1.0);
      at = transmission_cosine(l, -1);
      break;
    case Kind::transmission_max:
      at = transmission_cosine(l, 1);
      break;
    case Kind::time_ratio_min:
      sign = T(-1.0);
      at = imbalance_cosine(l, with);
      break;
    case Kind::time_ratio_max:
      at = imbalance_cosine(l, with);
      break;
  }
  at.value = sign * (at.value - T(limit.limit_cosine));
  for (T& slope : at.slope) slope = sign * slope;
  return at;
}

}  // namespace cognate::synthesis
