/// @file Angles as people write them.
#pragma once

namespace cognate::problems {

/// `radians` in degrees, for a name that ends in `_deg`: of the numbers that a problem file's
/// reader turns into exactly this angle the shortest one with up to 15 digits (45 rather than
/// 45.00000000000001), where there is one; else the nearest double.
double degrees(double radians);

}  // namespace cognate::problems
