/// @file The one spelling of each enum value, in problem files, results and reports alike.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <string_view>

#include "analysis/linkage/mobility.hpp"
#include "problems/cam/problem.hpp"
#include "problems/evaluation/problem.hpp"
#include "problems/gear/problem.hpp"
#include "problems/machine/problem.hpp"
#include "problems/problem.hpp"
#include "problems/result.hpp"

namespace cognate::problems {

/// A value of `Enum` and how it is written.
template <class Enum>
struct Named {
  std::string_view name;
  Enum value;
};

/// Every value of `Enum` with its name, in the order of its declaration. Specialised for the enums
/// below and for no others.
template <class Enum>
std::span<const Named<Enum>> names();

template <>
std::span<const Named<Assembly>> names<Assembly>();
template <>
std::span<const Named<MobilityClass>> names<MobilityClass>();
template <>
std::span<const Named<RequiredClass>> names<RequiredClass>();
template <>
std::span<const Named<MovingPoint>> names<MovingPoint>();
template <>
std::span<const Named<MovingLink>> names<MovingLink>();
template <>
std::span<const Named<SolverChoice>> names<SolverChoice>();
template <>
std::span<const Named<Timing>> names<Timing>();
template <>
std::span<const Named<CrankReference>> names<CrankReference>();
template <>
std::span<const Named<CrankSense>> names<CrankSense>();
template <>
std::span<const Named<PointOrder>> names<PointOrder>();
template <>
std::span<const Named<CurvePlace>> names<CurvePlace>();
template <>
std::span<const Named<PathMethod>> names<PathMethod>();
template <>
std::span<const Named<MotionMethod>> names<MotionMethod>();
template <>
std::span<const Named<FunctionStart>> names<FunctionStart>();
template <>
std::span<const Named<FunctionObjective>> names<FunctionObjective>();
template <>
std::span<const Named<BestBy>> names<BestBy>();
template <>
std::span<const Named<PointSpacing>> names<PointSpacing>();
template <>
std::span<const Named<Measure>> names<Measure>();
template <>
std::span<const Named<ErrorMeasure>> names<ErrorMeasure>();
template <>
std::span<const Named<MechanismType>> names<MechanismType>();
template <>
std::span<const Named<QuickReturnType>> names<QuickReturnType>();
template <>
std::span<const Named<DyadType>> names<DyadType>();
template <>
std::span<const Named<LoadSense>> names<LoadSense>();
template <>
std::span<const Named<MachineTask>> names<MachineTask>();
template <>
std::span<const Named<Status>> names<Status>();
template <>
std::span<const Named<Defect>> names<Defect>();
template <>
std::span<const Named<synthesis::Loss>> names<synthesis::Loss>();
template <>
std::span<const Named<synthesis::DyadKind>> names<synthesis::DyadKind>();
template <>
std::span<const Named<cam::FollowerType>> names<cam::FollowerType>();
template <>
std::span<const Named<cam::ArmSide>> names<cam::ArmSide>();
template <>
std::span<const Named<cam::Closure>> names<cam::Closure>();
template <>
std::span<const Named<cam::MotionLaw>> names<cam::MotionLaw>();
template <>
std::span<const Named<CamDimension>> names<CamDimension>();
template <>
std::span<const Named<MotionParameter>> names<MotionParameter>();
template <>
std::span<const Named<CamObjective>> names<CamObjective>();
template <>
std::span<const Named<Gearing>> names<Gearing>();
template <>
std::span<const Named<GearObjective>> names<GearObjective>();

/// How `value` is written, e.g. "crank-rocker"; empty for a number that is no value of the enum.
template <class Enum>
std::string_view to_string(Enum value) {
  const auto all = names<Enum>();
  const auto found = std::ranges::find(all, value, &Named<Enum>::value);
  return found == all.end() ? std::string_view{} : found->name;
}

/// The value written `name`, exactly; empty where there is none.
template <class Enum>
std::optional<Enum> from_string(std::string_view name) {
  const auto all = names<Enum>();
  const auto found = std::ranges::find(all, name, &Named<Enum>::name);
  return found == all.end() ? std::nullopt : std::optional(found->value);
}

}  // namespace cognate::problems
