/// @file What a study file holds before its first row.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "problems/study/study.hpp"

namespace cognate::app {

struct StudyOrigin;

/// Marks study files among SQLite's databases ("Cogn" in ASCII), and their format.
inline constexpr int kStudyApplicationId = 0x436F676E;
inline constexpr const char* kStudyFormat = "cognate-study-file/1";

/// The rows of the table `study`, by which a study is known again.
std::vector<std::pair<std::string, std::string>> study_identity(const problems::Study& study,
                                                                const StudyOrigin& origin);

/// The names of these rows, in their order.
std::vector<std::string> study_identity_names();

/// The statements that make the tables and the view `best`, as SQLite keeps them.
std::vector<std::string> study_schema(const problems::Study& study);

/// How a stored identity differs from the `wanted` one, in words; empty if it does not.
std::string study_difference(const std::vector<std::pair<std::string, std::string>>& stored,
                             const std::vector<std::pair<std::string, std::string>>& wanted);

}  // namespace cognate::app
