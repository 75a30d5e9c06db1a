/// @file The dimensions of any mechanism: every number of its tables, as its file would have them.
#pragma once

#include <vector>

#include "app/python/gradient.hpp"

namespace cognate::python {

/// All numbers of a mechanism, in the order of `convert`.
std::vector<double> numbers_of(const Mechanism<double>& mechanism);

/// The numbers in the tables of `mechanism`, chains and further points as well. What they change is
/// found by reading the tables again with the number changed: central differences of order eight,
/// exact but for roundings (some 1e-14), since the mechanism's numbers are linear in lengths and
/// places and analytic in angles.
std::vector<Dimension> written_dimensions(const problems::NamedMechanism& mechanism);

}  // namespace cognate::python
