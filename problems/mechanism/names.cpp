#include "problems/mechanism/load_sense.hpp"
#include "problems/mechanism/named_mechanism.hpp"

namespace cognate::problems {
namespace {

constexpr Named<MechanismType> kMechanismTypes[] = {
    {"four-bar", MechanismType::four_bar},
    {"slider-crank", MechanismType::slider_crank},
    {"guide-bar", MechanismType::guide_bar},
    {"oscillating-block", MechanismType::oscillating_block},
    {"fixed-block", MechanismType::fixed_block},
    {"scotch-yoke", MechanismType::scotch_yoke},
    {"tangent-generator", MechanismType::tangent_generator},
    {"elliptic-trammel", MechanismType::elliptic_trammel},
    {"oldham-coupling", MechanismType::oldham_coupling},
    {"chain", MechanismType::chain}};
constexpr Named<DyadType> kDyadTypes[] = {{"RRR", DyadType::rrr},
                                          {"RRP", DyadType::rrp},
                                          {"RPR", DyadType::rpr},
                                          {"PRP", DyadType::prp},
                                          {"RPP", DyadType::rpp}};
constexpr Named<LoadSense> kLoadSenses[] = {
    {"always", LoadSense::always}, {"advance", LoadSense::advance}, {"return", LoadSense::retreat}};

}  // namespace

template <>
std::span<const Named<MechanismType>> names<MechanismType>() {
  return kMechanismTypes;
}

template <>
std::span<const Named<DyadType>> names<DyadType>() {
  return kDyadTypes;
}

template <>
std::span<const Named<LoadSense>> names<LoadSense>() {
  return kLoadSenses;
}

}  // namespace cognate::problems
