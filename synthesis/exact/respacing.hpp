/// @file Precision points moved until the peaks of the structural error are level.
///
/// A function generator through n precision points has an error that vanishes there and peaks n + 1
/// times, between them and at the ends. Chebyshev's spacing would level the peaks of a polynomial;
/// for a linkage they come out unequal, and the points are to be spaced anew (Freudenstein 1959,
/// "Structural error analysis in plane kinematic synthesis"). With as many precision points as free
/// parameters p the level error is the least greatest error in the neighbourhood (de la
/// Vallée-Poussin): it is found by exchange as polynomials are (Remez 1934), each step solving
///
///     e(xᵢ) + ∂e/∂p(xᵢ)·Δp = (−1)ⁱ E,   i = 0…n,
///
/// for Δp and the level E at the n + 1 peaks xᵢ of the present error.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "analysis/linkage/four_bar.hpp"

namespace cognate::synthesis {

/// A four-bar with the angles, from A→D, from which input and output are counted.
struct GeneratingFourBar {
  Lengths<double> links;
  Assembly assembly = Assembly::open;
  double input_start = 0;
  double output_start = 0;
};

/// What is to be generated, and what may change for it: the ratios of the lengths always.
struct RespacingTask {
  std::function<double(double input)> output;  ///< both in radians from the start angles
  double from = 0, to = 0;                     ///< the input's range, from ≠ to
  bool input_start_free = false, output_start_free = false;

  /// How many precision points go with the free parameters: 3 to 5.
  int precision_points() const { return 3 + int(input_start_free) + int(output_start_free); }
};

/// Every way out of the exchange.
enum class RespacingOutcome {
  level,            ///< the peaks are equal within 1e-10 of their height
  not_alternating,  ///< the error of the start does not change sign once for each precision point
  not_closing,      ///< the linkage of the start does not close over the whole range
  stalled  ///< no step lowers the greatest error further: the best is at infinite lengths, or not
           ///< of level peaks
};

/// Where the exchange ended. With any outcome but `level` the linkage is the best one met, never
/// worse than the start.
struct Respacing {
  RespacingOutcome outcome = RespacingOutcome::stalled;
  GeneratingFourBar linkage;             ///< its crank is that of the start
  double greatest = 0;                   ///< |e| at its highest peak, radians
  double unevenness = 0;                 ///< (highest − lowest)/highest of the peaks
  std::vector<double> peaks;             ///< inputs of the peaks, in their order
  std::vector<double> precision_inputs;  ///< where the error vanishes
  int exchanges = 0;
};

/// The exchange from a linkage whose error changes sign `precision_points()` times in the range:
/// one through as many precision points.
Respacing equal_peaks(const RespacingTask& task, const GeneratingFourBar& start);

}  // namespace cognate::synthesis
