#include "problems/chain/problem.hpp"

namespace cognate::problems {
namespace {

constexpr Named<LimitSpan> kLimitSpans[] = {{"turn", LimitSpan::turn}, {"range", LimitSpan::range}};

constexpr Named<ChainMeasure> kChainMeasures[] = {
    {"transmission_angle", ChainMeasure::transmission_angle},
    {"size", ChainMeasure::size},
    {"links", ChainMeasure::links}};

}  // namespace

template <>
std::span<const Named<LimitSpan>> names<LimitSpan>() {
  return kLimitSpans;
}

template <>
std::span<const Named<ChainMeasure>> names<ChainMeasure>() {
  return kChainMeasures;
}

}  // namespace cognate::problems
