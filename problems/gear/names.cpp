#include "problems/gear/problem.hpp"

namespace cognate::problems {
namespace {

constexpr Named<Gearing> kGearings[] = {
    {"spur", Gearing::spur}, {"helical", Gearing::helical}, {"internal", Gearing::internal},
    {"rack", Gearing::rack}, {"bevel", Gearing::bevel},     {"worm", Gearing::worm}};
constexpr Named<GearObjective> kObjectives[] = {
    {"balanced-sliding", GearObjective::balanced_sliding},
    {"contact-ratio", GearObjective::contact_ratio},
    {"size", GearObjective::size}};

}  // namespace

template <>
std::span<const Named<Gearing>> names<Gearing>() {
  return kGearings;
}

template <>
std::span<const Named<GearObjective>> names<GearObjective>() {
  return kObjectives;
}

}  // namespace cognate::problems
