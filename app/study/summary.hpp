/// @file What a sweep says when it ends: a document and a table.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/console/screen.hpp"
#include "app/study/database.hpp"
#include "app/study/rows.hpp"
#include "app/study/run.hpp"
#include "problems/study/study.hpp"

namespace cognate::app {

struct StudySummary {
  StudyEnd end = StudyEnd::done;
  StudyCounts counts;
  StudyRows best;  ///< best first
  std::uint64_t seed = 1;
  std::vector<std::string> notes;
  double seconds = 0;          ///< of this run
  int threads = 1;             ///< that evaluated
  std::int64_t evaluated = 0;  ///< designs, by this run
};

/// `cognate-study/1`.
nlohmann::ordered_json study_document(const problems::Study& study, const StudySummary& summary);

/// What the study varies and wants, as that document has it.
nlohmann::ordered_json study_json(const problems::Study& study);

/// One line: the title or the base file, the number of designs and what varies.
std::string describe_study(const problems::Study& study);

/// A heading, how it ended, the counts, the best rows in columns, the notes, and the time.
std::string study_table(const problems::Study& study, const StudySummary& summary,
                        const Screen& screen);

}  // namespace cognate::app
