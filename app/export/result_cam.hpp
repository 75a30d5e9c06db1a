/// @file Cams as result files tell of them.
#pragma once

#include <string>
#include <tl/expected.hpp>

#include "app/export/result_document.hpp"
#include "problems/cam/result.hpp"

namespace cognate::app {

/// A cam with everything given, and the problem that gives it.
struct ResultCam {
  problems::CamProblem problem;
  problems::CamDesign design;
};

/// The cam of a design whose mechanism is of type "cam", made anew of its table `mechanism`. The
/// error is a message that begins with the document's name: what is wrong; what is allowed.
tl::expected<ResultCam, std::string> result_cam(const ResultDesign& given);

}  // namespace cognate::app
