#include "app/study/run.hpp"

#include <chrono>

#include "app/study/part.hpp"

namespace cognate::app {

StudyEnd run_study(StudyDatabase& database, StudyCrew& crew, const StudySteering& steering) {
  using Clock = std::chrono::steady_clock;
  constexpr auto kPatience = std::chrono::milliseconds(20);
  const auto begun = Clock::now();
  const auto is_time_over = [&] {
    return steering.time_limit &&
           std::chrono::duration<double>(Clock::now() - begun).count() >= *steering.time_limit;
  };
  auto end = StudyEnd::done;
  while (!crew.is_finished()) {
    if (const auto block = crew.wait(kPatience)) database.store(*block);
    database.tick();
    steering.progress();
    if (end != StudyEnd::done) continue;
    if (steering.interrupted) {
      end = StudyEnd::interrupted;
    } else if (is_time_over()) {
      end = StudyEnd::time_limit;
    }
    if (end != StudyEnd::done) {
      database.commit();  // whoever interrupts may soon do worse
      crew.stop();
    }
  }
  database.commit();
  // The last block may have come after all; and one of many processes may have been stopped alone.
  if (within(database.missing(), steering.designs).empty()) return StudyEnd::done;
  return end == StudyEnd::done ? StudyEnd::interrupted : end;
}

}  // namespace cognate::app
