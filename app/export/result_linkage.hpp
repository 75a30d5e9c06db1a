/// @file Linkages as result files tell of them.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "app/export/result_document.hpp"
#include "problems/evaluation/problem.hpp"

namespace cognate::app {

/// A linkage, the part of its drive in which it is shown, and what it was made for.
struct ResultLinkage {
  problems::AnalysisProblem problem;  ///< its outputs are the positions alone
  bool round = false;                 ///< whether the drive ends where it starts
  bool beyond = false;                ///< whether the drive goes a hair beyond what is assembled
  std::vector<double> stations;       ///< drive coordinates at the targets, where it has any
  std::vector<Vec2d> targets;         ///< points that it was to reach; of poses their origins
};

/// Whether a displacement drives the linkage rather than an angle.
bool is_driven_by_slider(const ResultLinkage& linkage);

/// The linkage of a design whose mechanism is none of type "cam", made anew of its table
/// `mechanism`. The drive is that of an analysis, else the range in which the linkage can be
/// assembled and that holds most of its stations, in 360 steps. The error is a message that begins
/// with the document's name: what is wrong; what is allowed.
tl::expected<ResultLinkage, std::string> result_linkage(const ResultDesign& given);

}  // namespace cognate::app
