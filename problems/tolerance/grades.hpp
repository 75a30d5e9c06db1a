/// @file Tolerances of standards: ISO 286-1 grades and ISO 2768-1 classes.
#pragma once

#include <optional>
#include <string_view>

#include "problems/basics/names.hpp"

namespace cognate::problems {

/// IT1…IT18 of ISO 286-1 (from `it1` on in this order), and fine, medium, coarse, very coarse of
/// ISO 2768-1.
enum class ToleranceGrade {
  it1,
  it2,
  it3,
  it4,
  it5,
  it6,
  it7,
  it8,
  it9,
  it10,
  it11,
  it12,
  it13,
  it14,
  it15,
  it16,
  it17,
  it18,
  fine,
  medium,
  coarse,
  very_coarse
};

/// The ± of a length of `nominal` > 0 mm, in mm: of ISO 286 half the grade's width, which lies
/// evenly about the nominal size (position js); of ISO 2768 the permissible deviation. Empty where
/// the standard has none: beyond 3150 mm of ISO 286 (IT14 to IT18: up to 1 mm, too), outside 0.5 to
/// 4000 mm of ISO 2768 (fine: to 2000 mm; very coarse: from 3 mm on).
///
/// Tables: ISO 286-1:2010, table 1; ISO 2768-1:1989, table 1.
std::optional<double> deviation_mm(ToleranceGrade grade, double nominal);

/// The lengths for which the grade has a value, in words.
std::string_view sizes_of(ToleranceGrade grade);

template <>
std::span<const Named<ToleranceGrade>> names<ToleranceGrade>();

}  // namespace cognate::problems
