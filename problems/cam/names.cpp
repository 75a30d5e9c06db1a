#include <algorithm>
#include <array>
#include <iterator>

#include "problems/cam/motion_laws.hpp"
#include "problems/cam/problem.hpp"

namespace cognate::problems {
namespace {

constexpr Named<cam::FollowerType> kFollowerTypes[] = {
    {"translating-roller", cam::FollowerType::translating_roller},
    {"translating-flat", cam::FollowerType::translating_flat},
    {"translating-knife", cam::FollowerType::translating_knife},
    {"oscillating-roller", cam::FollowerType::oscillating_roller},
    {"oscillating-flat", cam::FollowerType::oscillating_flat},
    {"oscillating-knife", cam::FollowerType::oscillating_knife}};
constexpr Named<cam::ArmSide> kArmSides[] = {{"trailing", cam::ArmSide::trailing},
                                             {"leading", cam::ArmSide::leading}};
constexpr Named<cam::Closure> kClosures[] = {{"force", cam::Closure::force},
                                             {"groove", cam::Closure::groove},
                                             {"conjugate", cam::Closure::conjugate},
                                             {"constant-breadth", cam::Closure::constant_breadth}};
constexpr Named<CamDimension> kCamDimensionNames[] = {
    {"base_radius", CamDimension::base_radius},
    {"offset", CamDimension::offset},
    {"roller_radius", CamDimension::roller_radius},
    {"centre_distance", CamDimension::centre_distance},
    {"arm", CamDimension::arm},
    {"face_offset", CamDimension::face_offset}};
constexpr Named<MotionParameter> kMotionParameters[] = {{"over_deg", MotionParameter::over},
                                                        {"sine", MotionParameter::sine},
                                                        {"constant", MotionParameter::constant},
                                                        {"cosine", MotionParameter::cosine}};
constexpr Named<CamObjective> kCamObjectives[] = {{"size", CamObjective::size},
                                                  {"pressure-angle", CamObjective::pressure_angle},
                                                  {"contact-force", CamObjective::contact_force},
                                                  {"torque", CamObjective::torque},
                                                  {"contact-stress", CamObjective::contact_stress}};

}  // namespace

template <>
std::span<const Named<cam::FollowerType>> names<cam::FollowerType>() {
  return kFollowerTypes;
}

template <>
std::span<const Named<cam::ArmSide>> names<cam::ArmSide>() {
  return kArmSides;
}

template <>
std::span<const Named<cam::Closure>> names<cam::Closure>() {
  return kClosures;
}

template <>
std::span<const Named<cam::MotionLaw>> names<cam::MotionLaw>() {
  static constexpr auto kNames = [] {
    std::array<Named<cam::MotionLaw>, std::size(kMotionLaws)> names;
    std::ranges::transform(kMotionLaws, names.begin(), [](const MotionLawDeclaration& declared) {
      return Named<cam::MotionLaw>{declared.word, declared.law};
    });
    return names;
  }();
  return kNames;
}

template <>
std::span<const Named<CamDimension>> names<CamDimension>() {
  return kCamDimensionNames;
}

template <>
std::span<const Named<MotionParameter>> names<MotionParameter>() {
  return kMotionParameters;
}

template <>
std::span<const Named<CamObjective>> names<CamObjective>() {
  return kCamObjectives;
}

}  // namespace cognate::problems
