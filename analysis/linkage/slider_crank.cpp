#include "analysis/linkage/slider_crank.hpp"

namespace cognate {

SliderCrank as_slider_crank(const FixedBlock& mechanism) {
  return {mechanism.pivot,  mechanism.crank,     mechanism.coupler,
          mechanism.offset, mechanism.direction, mechanism.assembly};
}

Mechanism<double> as_mechanism(const SliderCrank& mechanism) {
  const Rrp<double> dyad{.point = {1, {mechanism.crank, 0}},
                         .length = mechanism.coupler,
                         .guide = {0, mechanism.pivot, mechanism.direction, mechanism.offset},
                         .assembly = mechanism.assembly};
  return {Crank<double>{mechanism.pivot, mechanism.crank}, {dyad}};
}

Mechanism<double> as_mechanism(const FixedBlock& mechanism) {
  return as_mechanism(as_slider_crank(mechanism));
}

}  // namespace cognate
