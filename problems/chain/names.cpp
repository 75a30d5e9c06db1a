#include "problems/chain/problem.hpp"

namespace cognate::problems {
namespace {

constexpr Named<LimitSpan> kLimitSpans[] = {{"turn", LimitSpan::turn}, {"range", LimitSpan::range}};

}  // namespace

template <>
std::span<const Named<LimitSpan>> names<LimitSpan>() {
  return kLimitSpans;
}

}  // namespace cognate::problems
