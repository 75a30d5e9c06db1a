/// @file Screening and least-squares fits of function generators from many starts, one in each SIMD
/// lane.
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "analysis/batch/instruction_set.hpp"
#include "analysis/linkage/four_bar.hpp"
#include "synthesis/bounds/link_limit.hpp"
#include "synthesis/exact/freudenstein.hpp"
#include "synthesis/lanes/function_fit_kernel.hpp"

namespace cognate::synthesis {

/// A four-bar as a function generator: lengths in the order of FunctionUnknown, the angles that
/// input and output are counted from (radians, from the directed line A→D), ±1 for the assembly.
struct FunctionFitState {
  std::array<double, 4> length{};
  double input_start = 0, output_start = 0;
  double assembly = 1;

  /// Sum of squares and penalties; not a number where the linkage does not close or has not been
  /// fitted. An error e counts as 2 tan(e/2).
  double cost = std::numeric_limits<double>::quiet_NaN();
  int iterations = 0;
};

/// What is fitted: the unknowns of FunctionUnknown that are free, so that output angles come near
/// those wanted.
struct FunctionFit {
  std::vector<AnglePair> wanted;     ///< counted from the start angles
  std::vector<int> free;             ///< of FunctionUnknown, ascending
  std::vector<double> lower, upper;  ///< of each, finite for lengths; those of angles are not kept
  std::vector<LinkLimit> limits;
  /// Least and greatest cosine of the transmission angle at the samples.
  std::optional<std::array<double, 2>> transmission_cosine;
};

struct FunctionFitOptions {
  int most_iterations = 150;
  double tolerance = 1e-12;   ///< relative change of the cost at which a fit ends
  double negligible = 1e-30;  ///< cost that counts as zero
  double penalty = 10;        ///< weight of violated limits: see PathFitOptions
  int threads = 1;
  std::function<bool()> stop;         ///< asked now and then; fits not begun are left as they are
  std::optional<InstructionSet> set;  ///< the widest of the machine if empty
};

/// Fits all of `states` in place; those that start beyond a bound start at it. What comes of one
/// depends neither on the others nor on threads.
void fit_functions(const FunctionFit& problem, std::span<FunctionFitState> states,
                   const FunctionFitOptions& options);

/// Start angles of input and output, as a structure of arrays; the size is a multiple of `lanes`.
struct StartAngles {
  static constexpr std::size_t lanes = 8;
  explicit StartAngles(std::size_t count)
      : input_x(count),
        input_y(count),
        output_x(count),
        output_y(count),
        ratios{std::vector<double>(count), std::vector<double>(count), std::vector<double>(count)} {
  }
  std::vector<double> input_x, input_y, output_x, output_y;  ///< their directions
  std::array<std::vector<double>, 3> ratios;  ///< out: P₀, P₁, P₂; not finite where there are none
};

/// The ratios of Freudenstein's equation whose residuals over the desired pairs are least for each
/// of `starts`: first as they stand, then so many times over their slopes in the output angle,
/// which makes them errors in that angle to first order.
void fit_freudenstein(std::span<const AnglePair> wanted, int reweightings, StartAngles& starts);

/// Linkages to be screened, as a structure of arrays; the size is a multiple of `lanes`.
struct FunctionCandidates {
  static constexpr std::size_t lanes = 8;
  explicit FunctionCandidates(std::size_t count)
      : crank(count),
        coupler(count),
        rocker(count),
        frame(count),
        half_start_x(count),
        half_start_y(count),
        output_start_x(count),
        output_start_y(count),
        open(count),
        crossed(count) {}
  std::vector<double> crank, coupler, rocker, frame;
  std::vector<double> half_start_x, half_start_y;      ///< direction of half the input start angle
  std::vector<double> output_start_x, output_start_y;  ///< that of the output's, where it is given
  /// Out, of each assembly: mean square of 2 sin(e/2), e being the error; not a number where the
  /// linkage does not close.
  std::vector<double> open, crossed;
};

/// What the output's start angle is: as given, or the best for each candidate.
enum class OutputStart { given, best };

void screen(std::span<const AnglePair> wanted, OutputStart start, FunctionCandidates& candidates);

}  // namespace cognate::synthesis
