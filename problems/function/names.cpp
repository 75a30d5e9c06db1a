#include "problems/function/problem.hpp"

namespace cognate::problems {
namespace {

constexpr Named<FunctionStart> kFunctionStarts[] = {
    {"free", FunctionStart::free},
    {"outer-dead-centre", FunctionStart::outer_dead_centre},
    {"inner-dead-centre", FunctionStart::inner_dead_centre}};
constexpr Named<FunctionObjective> kFunctionObjectives[] = {
    {"exact", FunctionObjective::exact},
    {"least-squares", FunctionObjective::least_squares},
    {"minimax", FunctionObjective::minimax}};
constexpr Named<PointSpacing> kPointSpacings[] = {{"chebyshev", PointSpacing::chebyshev},
                                                  {"equal-peaks", PointSpacing::equal_peaks}};
constexpr Named<BestBy> kBestBy[] = {{"error", BestBy::error},
                                     {"transmission", BestBy::transmission}};

}  // namespace

template <>
std::span<const Named<FunctionStart>> names<FunctionStart>() {
  return kFunctionStarts;
}

template <>
std::span<const Named<FunctionObjective>> names<FunctionObjective>() {
  return kFunctionObjectives;
}

template <>
std::span<const Named<PointSpacing>> names<PointSpacing>() {
  return kPointSpacings;
}

template <>
std::span<const Named<BestBy>> names<BestBy>() {
  return kBestBy;
}

}  // namespace cognate::problems
