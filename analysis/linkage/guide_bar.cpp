#include "analysis/linkage/guide_bar.hpp"

namespace cognate {

GuideBar as_guide_bar(const OscillatingBlock& mechanism) {
  return {mechanism.pivot_a, mechanism.pivot_c, mechanism.crank, mechanism.offset,
          mechanism.assembly};
}

Mechanism<double> as_mechanism(const GuideBar& mechanism) {
  const Rpr<double> dyad{.block = {1, {mechanism.crank, 0}},
                         .pivot = {0, mechanism.pivot_c},
                         .offset = mechanism.offset,
                         .assembly = mechanism.assembly};
  return {Crank<double>{mechanism.pivot_a, mechanism.crank}, {dyad}};
}

Mechanism<double> as_mechanism(const OscillatingBlock& mechanism) {
  const Rpr<double> dyad{.block = {0, mechanism.pivot_c},
                         .pivot = {1, {mechanism.crank, 0}},
                         .offset = mechanism.offset,
                         .assembly = mechanism.assembly};
  return {Crank<double>{mechanism.pivot_a, mechanism.crank}, {dyad}};
}

}  // namespace cognate
