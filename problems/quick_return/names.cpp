#include "problems/quick_return/problem.hpp"

namespace cognate::problems {
namespace {

constexpr Named<QuickReturnType> kQuickReturnTypes[] = {
    {"four-bar", QuickReturnType::four_bar},
    {"slider-crank", QuickReturnType::slider_crank},
    {"guide-bar", QuickReturnType::guide_bar},
    {"shaper", QuickReturnType::shaper}};

}  // namespace

template <>
std::span<const Named<QuickReturnType>> names<QuickReturnType>() {
  return kQuickReturnTypes;
}

}  // namespace cognate::problems
