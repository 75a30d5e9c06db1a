/// @file The texts that a new file may begin with.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cognate::app {

/// A worked problem of the library, in the program as it stands there.
struct WorkedProblem {
  std::string_view name;  ///< "path/ten-point-ellipse"
  std::string_view text;
};

/// By name; those that name no other file.
std::span<const WorkedProblem> worked_problems();

struct Template {
  std::string name;        ///< "new/cam", or that of a worked problem
  std::string_view title;  ///< of its text; empty where it has none
};

/// The files of `cognate new`, which solve as they stand, and then the worked problems.
std::vector<Template> templates();

/// The text of a template; nothing where there is none of that name.
std::optional<std::string_view> template_text(std::string_view name);

}  // namespace cognate::app
