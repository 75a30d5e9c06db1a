#include "problems/path/problem.hpp"

namespace cognate::problems {
namespace {

constexpr Named<Timing> kTimings[] = {
    {"free", Timing::free}, {"prescribed", Timing::prescribed}, {"mixed", Timing::mixed}};
constexpr Named<CrankReference> kCrankReferences[] = {{"first", CrankReference::first},
                                                      {"frame", CrankReference::frame},
                                                      {"global", CrankReference::global}};
constexpr Named<CrankSense> kCrankSenses[] = {
    {"either", CrankSense::either}, {"ccw", CrankSense::ccw}, {"cw", CrankSense::cw}};
constexpr Named<CurvePlace> kCurvePlaces[] = {{"given", CurvePlace::given},
                                              {"similar", CurvePlace::similar}};
constexpr Named<PathMethod> kPathMethods[] = {{"least-squares", PathMethod::least_squares},
                                              {"exact", PathMethod::exact}};

}  // namespace

template <>
std::span<const Named<Timing>> names<Timing>() {
  return kTimings;
}

template <>
std::span<const Named<CrankReference>> names<CrankReference>() {
  return kCrankReferences;
}

template <>
std::span<const Named<CrankSense>> names<CrankSense>() {
  return kCrankSenses;
}

template <>
std::span<const Named<CurvePlace>> names<CurvePlace>() {
  return kCurvePlaces;
}

template <>
std::span<const Named<PathMethod>> names<PathMethod>() {
  return kPathMethods;
}

}  // namespace cognate::problems
