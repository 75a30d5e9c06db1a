/// @file The derivative of a function of which only values are known.
#pragma once

#include <functional>

namespace cognate::problems::reading {

/// f′ by central differences of the eighth order, with steps from 0.01 down that are halved until
/// two agree to rounding, and with the plain difference close to the place. Of a smooth f whose
/// bumps are no narrower than 0.001 it is true to about 1e-10 of the greatest slope; of narrower
/// ones less so, and next to a corner it is of one side or the other.
std::function<double(double)> derivative(std::function<double(double)> f);

}  // namespace cognate::problems::reading
