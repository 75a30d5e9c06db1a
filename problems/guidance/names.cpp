#include "problems/guidance/problem.hpp"

namespace cognate::problems {
namespace {

constexpr Named<MotionMethod> kMotionMethods[] = {{"exact", MotionMethod::exact},
                                                  {"least-squares", MotionMethod::least_squares}};
constexpr Named<synthesis::DyadKind> kDyadKinds[] = {{"RR", synthesis::DyadKind::rr},
                                                     {"PR", synthesis::DyadKind::pr},
                                                     {"RP", synthesis::DyadKind::rp}};

}  // namespace

template <>
std::span<const Named<MotionMethod>> names<MotionMethod>() {
  return kMotionMethods;
}

template <>
std::span<const Named<synthesis::DyadKind>> names<synthesis::DyadKind>() {
  return kDyadKinds;
}

}  // namespace cognate::problems
