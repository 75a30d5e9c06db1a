#include "problems/basics/length_unit.hpp"

namespace cognate::problems {
namespace {

constexpr Named<LengthUnit> kLengthUnits[] = {
    {"mm", LengthUnit::mm}, {"cm", LengthUnit::cm}, {"m", LengthUnit::m}, {"in", LengthUnit::inch}};

}  // namespace

double metres(std::optional<LengthUnit> unit) {
  if (!unit) return 1;
  switch (*unit) {
    case LengthUnit::mm:
      return 1e-3;
    case LengthUnit::cm:
      return 1e-2;
    case LengthUnit::m:
      return 1;
    case LengthUnit::inch:
      return 25.4e-3;
  }
  return 1;
}

std::string_view length_word(std::optional<LengthUnit> unit) {
  return unit ? to_string(*unit) : std::string_view{};
}

std::string in_length_unit(std::string unit, std::string_view length) {
  constexpr std::string_view kLength = "length";
  if (length.empty()) return unit;
  for (auto at = unit.find(kLength); at != std::string::npos;
       at = unit.find(kLength, at + length.size())) {
    unit.replace(at, kLength.size(), length);
  }
  return unit;
}

template <>
std::span<const Named<LengthUnit>> names<LengthUnit>() {
  return kLengthUnits;
}

}  // namespace cognate::problems
