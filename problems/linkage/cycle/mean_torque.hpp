/// @file The root mean square of the driving torque over the turn, for the search.
#pragma once

#include "problems/linkage/cycle/operation.hpp"
#include "problems/linkage/sector_extremes.hpp"

namespace cognate::problems {

/// The mean of T² over the crank's turn, with its derivatives by the dimensions; not a number where
/// the linkage does not close. By Gauss's rule of five places in equal parts of the turn, cut where
/// the rocker turns back: loads of one stroke begin and cease there, and their torque, which goes
/// with the rocker's rate, has a kink but no jump, so that the places need no derivatives.
DimensionJet mean_square_torque(const Operation& operation, const CycleTable& table);

}  // namespace cognate::problems
