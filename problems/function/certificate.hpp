/// @file The certificate of function generation by least squares.
#pragma once

#include "problems/function/samples.hpp"
#include "problems/linkage/certifying.hpp"
#include "synthesis/bounds/function_bound.hpp"

namespace cognate::problems {

/// What a file's constraints leave to look at.
struct FunctionDomain {
  synthesis::FunctionBound bound;
  std::vector<synthesis::ProportionBox> roots;
  std::string text;
};

/// Of a least-squares problem. Transmission angle and closing are requested at the samples alone
/// where the crank does not turn fully, and bounds of the output's start are left out, so that more
/// designs are looked at than the file allows.
FunctionDomain function_domain(const FunctionProblem& problem, const FunctionSamples& wanted);

/// Proves how much better than `upper` a design may be.
Certificate certify(const FunctionProblem& problem, const FunctionSamples& wanted, double upper,
                    const Run& run, const Deadline& deadline);

}  // namespace cognate::problems
