#include <array>
#include <type_traits>
#include <variant>

#include "problems/mechanism/load_rule.hpp"
#include "problems/mechanism/mechanism_types.hpp"

namespace cognate::problems {
namespace {

template <class... Type>
constexpr std::array<Named<MechanismType>, sizeof...(Type)> words_of(
    std::type_identity<std::variant<Type...>>) {
  int number = 0;
  return {Named<MechanismType>{TypeTraits<Type>::kWord, MechanismType{number++}}...};
}

constexpr auto kMechanismTypes = words_of(std::type_identity<MechanismDescription>{});
constexpr Named<DyadType> kDyadTypes[] = {{"RRR", DyadType::rrr}, {"RRP", DyadType::rrp},
                                          {"RPR", DyadType::rpr}, {"PRP", DyadType::prp},
                                          {"RPP", DyadType::rpp}, {"group", DyadType::group}};
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
