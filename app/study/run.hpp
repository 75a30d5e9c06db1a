/// @file Running a study: from a crew's blocks to the study file.
#pragma once

#include <atomic>
#include <functional>
#include <optional>

#include "app/study/crew.hpp"
#include "app/study/database.hpp"
#include "app/study/design_range.hpp"

namespace cognate::app {

enum class StudyEnd { done, interrupted, time_limit };

/// How a run is steered from outside.
struct StudySteering {
  const std::atomic<bool>& interrupted;
  std::optional<double> time_limit;   ///< seconds
  std::function<void()> progress;     ///< called some times a second
  DesignRange designs = kAllDesigns;  ///< which are to be evaluated
};

/// Stores the blocks of `crew` until there are no more, or it is interrupted, or the time is over.
/// What was stored until then is committed. `done` where all designs to be evaluated are;
/// interrupted, too, where some of the crew gave up by themselves. Throws as StudyDatabase and the
/// crew do.
StudyEnd run_study(StudyDatabase& database, StudyCrew& crew, const StudySteering& steering);

}  // namespace cognate::app
