/// @file Cams as result files tell of them.
#pragma once

#include <filesystem>
#include <string>
#include <tl/expected.hpp>

#include "problems/cam/cam_result.hpp"

namespace cognate::app {

/// A cam with everything given, and the problem that gives it.
struct ResultCam {
  problems::CamProblem problem;
  problems::CamDesign design;
};

/// Design number `design`, counted from 1, of the result document in `file`, made anew of its
/// table `mechanism`. The error is a message that begins with the file's name: what is wrong; what
/// is allowed.
tl::expected<ResultCam, std::string> read_result_cam(const std::filesystem::path& file, int design);

/// The same for the text of a document; `name` is what messages call it.
tl::expected<ResultCam, std::string> parse_result_cam(std::string_view text, int design,
                                                      const std::string& name);

}  // namespace cognate::app
