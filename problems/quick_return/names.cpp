#include "problems/quick_return/problem.hpp"

namespace cognate::problems {
namespace {

constexpr Named<QuickReturnType> kQuickReturnTypes[] = {
    {"four-bar", QuickReturnType::four_bar},
    {"slider-crank", QuickReturnType::slider_crank},
    {"guide-bar", QuickReturnType::guide_bar},
    {"shaper", QuickReturnType::shaper}};

constexpr Named<ReturnLength> kReturnLengthNames[] = {
    {"crank", ReturnLength::crank},   {"coupler", ReturnLength::coupler},
    {"rocker", ReturnLength::rocker}, {"frame", ReturnLength::frame},
    {"offset", ReturnLength::offset}, {"bar", ReturnLength::bar},
    {"rod", ReturnLength::rod},       {"ram_height", ReturnLength::ram_height}};

}  // namespace

std::string_view limit_angle_key(synthesis::RockerLimit limit) {
  return limit == synthesis::RockerLimit::outer ? "outer_limit_deg" : "inner_limit_deg";
}

template <>
std::span<const Named<QuickReturnType>> names<QuickReturnType>() {
  return kQuickReturnTypes;
}

template <>
std::span<const Named<ReturnLength>> names<ReturnLength>() {
  return kReturnLengthNames;
}

}  // namespace cognate::problems
