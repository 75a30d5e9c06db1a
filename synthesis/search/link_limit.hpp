/// @file A limit on the four link lengths as data, for models and kernels alike.
#pragma once

namespace cognate::synthesis {

/// A smooth function of the lengths that is to be ≥ 0. Lengths and weights are in the order crank,
/// coupler, rocker, frame.
struct LinkLimit {
  enum class Kind {
    linear,            ///< weights · lengths − margin
    grashof_excess,    ///< weights[0] · (shortest + longest − the other two)
    transmission_min,  ///< limit_cosine − cos μ with the crank along the frame, towards D
    transmission_max   ///< cos μ − limit_cosine with the crank along the frame, away from D
  };
  Kind kind = Kind::linear;
  double weights[4] = {};
  double limit_cosine = 0;
  double margin = 0;
};

}  // namespace cognate::synthesis
