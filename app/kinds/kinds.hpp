/// @file What the program does with each kind of problem: the one header of the program that names
/// them all.
#pragma once

#include "app/kinds/cam/kind.hpp"
#include "app/kinds/chain/kind.hpp"
#include "app/kinds/chain_function/kind.hpp"
#include "app/kinds/chain_motion/kind.hpp"
#include "app/kinds/dwell/kind.hpp"
#include "app/kinds/evaluation/kind.hpp"
#include "app/kinds/function/kind.hpp"
#include "app/kinds/gear/kind.hpp"
#include "app/kinds/guidance/kind.hpp"
#include "app/kinds/leg/kind.hpp"
#include "app/kinds/machine/kind.hpp"
#include "app/kinds/path/kind.hpp"
#include "app/kinds/quick_return/kind.hpp"
#include "app/kinds/straight_line/kind.hpp"
#include "app/kinds/train/kind.hpp"
#include "problems/kinds.hpp"

namespace cognate::app {

/// Calls `visit` with the kind of `task`, a type, and the problem of that kind.
template <class Visit>
auto visit_kind(const problems::Task& task, Visit visit) {
  return std::visit(
      [&]<class Problem>(const Problem& problem) { return visit(Kind<Problem>{}, problem); }, task);
}

/// All lists of metrics and columns, those of every linkage first.
std::vector<MetricList> metric_lists();

}  // namespace cognate::app
