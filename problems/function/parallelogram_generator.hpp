/// @file Function generators whose output turns as fast as the input, which Freudenstein's equation
/// does not determine.
#pragma once

#include <optional>
#include <string>

#include "problems/function/generator.hpp"
#include "problems/function/problem.hpp"

namespace cognate::problems {

/// Output = `sense`·input + `offset`.
struct EqualTurning {
  double sense = 1;  ///< +1 or −1
  double offset = 0;
};

/// How the output turns, where it turns by the input's angle at all of `wanted`, to 1e-8.
std::optional<EqualTurning> equal_turning(const FunctionSamples& wanted);

/// A parallelogram in the file's scale whose output turns with its input, `offset` ahead of it. A
/// start that is free is such that the input link stands across the frame in the middle of the
/// motion, or as near to it as its bounds allow; the frame, which may be of any length, is twice
/// the crank. Empty where the starts given differ by another angle.
std::optional<FunctionGenerator> parallelogram(const FunctionProblem& problem,
                                               const FunctionSamples& wanted, double offset);

/// What no four-bar does: why the given starts exclude a parallelogram, or that the output turns
/// the other way.
std::string equal_turning_note(const EqualTurning& turning);

}  // namespace cognate::problems
