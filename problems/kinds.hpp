/// @file Every kind of problem: the one header that names them all.
#pragma once

#include <type_traits>
#include <variant>

#include "problems/cam/problem.hpp"
#include "problems/chain/problem.hpp"
#include "problems/chain_function/problem.hpp"
#include "problems/chain_motion/problem.hpp"
#include "problems/dwell/problem.hpp"
#include "problems/evaluation/problem.hpp"
#include "problems/function/problem.hpp"
#include "problems/gear/problem.hpp"
#include "problems/guidance/problem.hpp"
#include "problems/leg/problem.hpp"
#include "problems/machine/problem.hpp"
#include "problems/path/problem.hpp"
#include "problems/quick_return/problem.hpp"
#include "problems/straight_line/problem.hpp"
#include "problems/train/problem.hpp"

namespace cognate::problems {

/// The list of all kinds of problem. Messages name them in this order, those of
/// one word once.
using Task = std::variant<PathProblem, ChainPathProblem, FunctionProblem, ChainFunctionProblem,
                          DwellProblem, MotionProblem, ChainMotionProblem, QuickReturnProblem,
                          StraightLineProblem, LegProblem, CamProblem, GearProblem, GearPairProblem,
                          GearTrainProblem, AnalysisProblem, MachineProblem>;

/// Calls `visit` with `std::type_identity` of each kind of problem, in the order of `Task`.
template <class Visit>
constexpr void for_each_kind(Visit visit) {
  const auto fold = [&]<class... Kind>(std::type_identity<std::variant<Kind...>>) {
    (visit(std::type_identity<Kind>{}), ...);
  };
  fold(std::type_identity<Task>{});
}

}  // namespace cognate::problems
