/// @file Chebyshev's spacing of precision points.
#pragma once

#include <vector>

namespace cognate::synthesis {

/// `count` abscissae on (first, last), the roots of Chebyshev's polynomial carried there:
/// xᵢ = (first + last)/2 − (last − first)/2 · cos((2i − 1)π/(2·count)), i = 1…count
/// (Freudenstein 1955). Symmetric about the middle to the last bit.
std::vector<double> chebyshev_spacing(double first, double last, int count);

}  // namespace cognate::synthesis
