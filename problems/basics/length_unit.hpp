/// @file The unit in which a file gives its lengths.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "problems/basics/names.hpp"

namespace cognate::problems {

/// `length_unit` of a file. In this unit are lengths, velocities, accelerations and gravity, and
/// what is given by length or by area: masses by length, rates of springs, moduli, stresses.
/// Torques and moments (N·m), inertias (kg·m²), work (J) and power (W) are in metres for any unit.
enum class LengthUnit { mm, cm, m, inch };

/// How many metres the unit has. Without a unit lengths count as metres wherever forces are
/// computed, so that this is 1.
double metres(std::optional<LengthUnit> unit);

/// "mm"; empty where there is none.
std::string_view length_word(std::optional<LengthUnit> unit);

/// `unit`, which may name lengths ("length", "length/s2", "1/length"), for lengths in `length`:
/// "mm", "mm/s2", "1/mm". Unchanged where `length` is empty.
std::string in_length_unit(std::string unit, std::string_view length);

template <>
std::span<const Named<LengthUnit>> names<LengthUnit>();

}  // namespace cognate::problems
