#include <algorithm>
#include <array>
#include <iterator>

#include "problems/linkage/linkage_limits.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {
namespace {

constexpr Named<Assembly> kAssemblies[] = {{"open", Assembly::open},
                                           {"crossed", Assembly::crossed}};
constexpr Named<MobilityClass> kMobilityClasses[] = {
    {"crank-rocker", MobilityClass::crank_rocker},
    {"double-crank", MobilityClass::double_crank},
    {"rocker-crank", MobilityClass::rocker_crank},
    {"double-rocker", MobilityClass::double_rocker},
    {"triple-rocker", MobilityClass::triple_rocker}};
constexpr Named<RequiredClass> kRequiredClasses[] = {
    {"crank-rocker", RequiredClass::crank_rocker},
    {"double-crank", RequiredClass::double_crank},
    {"rocker-crank", RequiredClass::rocker_crank},
    {"double-rocker", RequiredClass::double_rocker},
    {"triple-rocker", RequiredClass::triple_rocker},
    {"grashof", RequiredClass::grashof},
    {"non-grashof", RequiredClass::non_grashof}};
constexpr Named<MovingPoint> kMovingPoints[] = {
    {"coupler-point", MovingPoint::coupler_point}, {"B", MovingPoint::b}, {"C", MovingPoint::c}};
constexpr Named<MovingLink> kMovingLinks[] = {
    {"crank", MovingLink::crank}, {"coupler", MovingLink::coupler}, {"rocker", MovingLink::rocker}};
constexpr Named<DesignObjective> kGeometricObjectives[] = {
    {"error", DesignObjective::error},
    {"transmission_angle", DesignObjective::transmission_angle},
    {"link_ratio", DesignObjective::link_ratio},
    {"size", DesignObjective::size}};
constexpr auto kObjectives = [] {
  std::array<Named<DesignObjective>, std::size(kGeometricObjectives) + kCycleQuantities.size()>
      all{};
  const auto named = [](const CycleDeclaration& quantity) {
    return Named<DesignObjective>{quantity.key(), objective_of(quantity.id)};
  };
  std::ranges::transform(kCycleQuantities, std::ranges::copy(kGeometricObjectives, all.begin()).out,
                         named);
  return all;
}();
constexpr Named<ErrorMeasure> kErrorMeasures[] = {
    {"rms_error_max", ErrorMeasure::rms_length},
    {"rms_error_deg_max", ErrorMeasure::rms_angle},
    {"max_error_max", ErrorMeasure::largest_length},
    {"max_error_deg_max", ErrorMeasure::largest_angle}};
constexpr Named<synthesis::Loss> kLosses[] = {
    {"none", synthesis::Loss::none},       {"huber", synthesis::Loss::huber},
    {"soft-l1", synthesis::Loss::soft_l1}, {"cauchy", synthesis::Loss::cauchy},
    {"arctan", synthesis::Loss::arctan},   {"tukey", synthesis::Loss::tukey}};
constexpr Named<Phase> kPhases[] = {{"search", Phase::search},
                                    {"exact solutions", Phase::exact},
                                    {"front", Phase::front},
                                    {"raster", Phase::raster},
                                    {"robustness", Phase::robustness},
                                    {"conflicts", Phase::infeasibility},
                                    {"certificate", Phase::certificate},
                                    {"positions", Phase::positions},
                                    {"tolerances", Phase::tolerances},
                                    {"layers", Phase::layers},
                                    {"simulation", Phase::simulation}};

constexpr Named<Status> kStatuses[] = {
    {"solved", Status::solved},           {"infeasible", Status::infeasible},
    {"no-solution", Status::no_solution}, {"time-limit", Status::time_limit},
    {"interrupted", Status::interrupted}, {"invalid", Status::invalid}};
constexpr Named<Defect> kDefects[] = {
    {"circuit", Defect::circuit}, {"branch", Defect::branch}, {"order", Defect::order}};
constexpr Named<PointOrder> kPointOrders[] = {{"cyclic", PointOrder::cyclic},
                                              {"any", PointOrder::any}};

}  // namespace

template <>
std::span<const Named<Assembly>> names<Assembly>() {
  return kAssemblies;
}

template <>
std::span<const Named<MobilityClass>> names<MobilityClass>() {
  return kMobilityClasses;
}

template <>
std::span<const Named<RequiredClass>> names<RequiredClass>() {
  return kRequiredClasses;
}

template <>
std::span<const Named<MovingPoint>> names<MovingPoint>() {
  return kMovingPoints;
}

template <>
std::span<const Named<MovingLink>> names<MovingLink>() {
  return kMovingLinks;
}

template <>
std::span<const Named<synthesis::Solver>> names<synthesis::Solver>() {
  static constexpr auto kNames = [] {
    std::array<Named<synthesis::Solver>, synthesis::kSolvers.size()> all;
    std::ranges::transform(synthesis::kSolvers, all.begin(), [](const auto& solver) {
      return Named<synthesis::Solver>{solver.name, solver.id};
    });
    return all;
  }();
  return kNames;
}

template <>
std::span<const Named<DesignObjective>> names<DesignObjective>() {
  return kObjectives;
}

template <>
std::span<const Named<ErrorMeasure>> names<ErrorMeasure>() {
  return kErrorMeasures;
}

template <>
std::span<const Named<synthesis::Loss>> names<synthesis::Loss>() {
  return kLosses;
}

template <>
std::span<const Named<Phase>> names<Phase>() {
  return kPhases;
}

template <>
std::span<const Named<Status>> names<Status>() {
  return kStatuses;
}

template <>
std::span<const Named<Defect>> names<Defect>() {
  return kDefects;
}

template <>
std::span<const Named<PointOrder>> names<PointOrder>() {
  return kPointOrders;
}

}  // namespace cognate::problems
